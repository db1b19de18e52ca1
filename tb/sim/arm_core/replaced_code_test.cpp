// Code that is replaced by others: by a loader from outside, Thumb code where ARM code was, under a
// breakpoint.  The new one is executed, and counted exactly.
#include <gmock/gmock.h>

#include "tb/sim/arm_core/bench.h"

namespace replaced_code {

using namespace tb::core;
using sim::ArmStop;
using ::testing::ElementsAre;

constexpr std::uint32_t AT = 0x8000, TARGET = 0x9000, THUMB = 1;
constexpr std::uint32_t NOP = 0xE320F000, WFI = 0xE320F003, BX_LR = 0xE12FFF1E;
constexpr std::uint32_t ADD_1 = 0xE2800001, ADD_16 = 0xE2800010;  // ADD r0, r0, #n

class ReplacedCode : public ::testing::Test {
protected:
    // From `at` to WFI, with r0 zero before.  How many instructions.
    std::uint64_t run_from(std::uint32_t at) {
        const std::uint64_t before = bench.core.instructions();
        bench.core.set_reg(0, 0);
        bench.core.set_cpsr(0x1D3 | (at & 1) << 5);
        bench.core.set_reg(15, at);
        EXPECT_EQ(bench.core.run(1000), ArmStop::WFI);
        return bench.core.instructions() - before;
    }
    std::uint32_t result() const { return bench.core.reg(0); }

    Bench bench;
};

// ---- From outside -------------------------------------------------------------------------------

// ADD, SUBS, BNE: `laps` of them.
class ReplacedLoop : public ReplacedCode {
protected:
    void expect(unsigned laps, std::uint32_t sum) {
        bench.core.set_reg(4, laps);
        EXPECT_EQ(run_from(AT), 3 * laps + 1);
        EXPECT_EQ(result(), sum);
    }
    void SetUp() override {
        bench.put(AT, {
                          ADD_1,
                          0xE2544001,  // SUBS r4, r4, #1
                          0x1AFFFFFC,  // BNE to the begin
                          WFI,
                      });
        expect(100, 100);
    }
};

TEST_F(ReplacedLoop, IsTheNewOneWhenALoaderHasWrittenIt) {
    bench.put(AT, {ADD_16});
    expect(100, 1600);
}

TEST_F(ReplacedLoop, IsNewAfterAReportedWriteToRam) {
    std::memcpy(bench.memory() + AT, &ADD_16, 1);
    bench.core.forget_translations(AT, 1);
    expect(100, 1600);
}

TEST_F(ReplacedLoop, IsNewAfterOtherRamIsMapped) {
    Bench other;
    std::memcpy(other.memory(), bench.memory() + AT, 0x1000);
    std::memcpy(other.memory(), &ADD_16, 4);
    bench.core.unmap(0, RAM);
    bench.core.map_ram(AT, 0x1000, other.memory());
    expect(100, 1600);
}

// ---- Another instruction set at the same address ------------------------------------------------

class ReplacedState : public ReplacedCode {
protected:
    ReplacedState() { bench.core.set_reg(7, BUS); }
};

TEST_F(ReplacedState, IsThumbAfterThumbOverArm) {
    bench.core.set_reg(1, TARGET);
    bench.core.set_reg(2, 0x30103010);  // ADDS r0, #16, twice
    bench.core.set_reg(3, 0xBF004770);  // BX lr; NOP
    bench.core.set_reg(6, TARGET | THUMB);
    bench.core.set_reg(8, ADD_16);
    bench.core.set_reg(9, BX_LR);
    bench.put(TARGET, {ADD_1, BX_LR});
    bench.put(AT, {
                      0xE12FFF31,  // BLX r1
                      0xE881000C,  // STM r1, {r2, r3}
                      0xE12FFF36,  // BLX r6
                      0xE8810300,  // STM r1, {r8, r9}
                      0xE12FFF31,  // BLX r1
                      WFI,
                  });
    EXPECT_EQ(run_from(AT), 6u + 2 + 3 + 2);
    EXPECT_EQ(result(), 1u + 32 + 16);
}

TEST_F(ReplacedState, IsEitherAtOnceWhereAWordIsBoth) {
    bench.put(TARGET, {
                          0xE2800009,  // ADD r0, r0, #9; in Thumb: MOVS r1, r1; B to TARGET + 0x506
                          BX_LR,
                      });
    bench.put_halves(TARGET + 0x506, {0x3010, 0x4770});  // ADDS r0, #16; BX lr
    bench.put(AT, {
                      0xE12FFF31,  // BLX r1
                      0xE12FFF32,  // BLX r2
                      0xE12FFF31,  // BLX r1
                      0xE12FFF32,  // BLX r2
                      WFI,
                  });
    bench.core.set_reg(1, TARGET);
    bench.core.set_reg(2, TARGET | THUMB);
    EXPECT_EQ(run_from(AT), 5u + 2 * (2 + 4));
    EXPECT_EQ(result(), 50u);
}

// The bus access comes after the begin of an earlier Thumb block.
TEST_F(ReplacedState, CountsArmCodeAnewWhereThumbCodeWas) {
    bench.put_halves(TARGET,
                     {0xBF00, 0xBF00, 0xBF00, 0xBF00, 0xBF00, 0xBF30, 0xE7FE});  // NOPs, WFI, B
    EXPECT_EQ(run_from((TARGET + 2) | THUMB), 5u);
    bench.put(TARGET, {
                          NOP, NOP,
                          0xE5976000,  // LDR r6, [r7]
                          WFI,
                          0xEAFFFFFE,  // B to itself
                      });
    EXPECT_EQ(run_from(TARGET), 4u);
    EXPECT_EQ(run_from(TARGET), 4u);
    EXPECT_EQ(bench.accesses.size(), 2u);
}

// The second time, an instruction of 32 bits lies where two blocks met.
TEST_F(ReplacedState, CountsAnewWhereInstructionsOfThumbWereCutOtherwise) {
    bench.put_halves(TARGET, {0xBF00, 0xBF00, 0xBF00, 0xBF00, 0xBF00, 0xBF30, 0xE7FE});
    EXPECT_EQ(run_from((TARGET + 4) | THUMB), 4u);
    bench.put_halves(TARGET, {0xBF00,            // NOP
                              0xF100, 0x0010,    // ADD.W r0, r0, #16
                              0xBF00,            // NOP
                              0x683E,            // LDR r6, [r7]
                              0xBF30, 0xE7FE});  // WFI
    EXPECT_EQ(run_from(TARGET | THUMB), 5u);
    EXPECT_EQ(run_from(TARGET | THUMB), 5u);
    EXPECT_EQ(result(), 16u);
}

// Nothing is overwritten: what is the second half of one instruction is another one.
TEST_F(ReplacedState, CountsBothWaysThroughHalvesThatAreReadTwice) {
    bench.put_halves(TARGET, {0xBF00,            // NOP
                              0xF04F, 0x3310,    // MOV.W r3, #0x10101010; ADDS r3, #0x10
                              0xBF00,            // NOP
                              0x683E,            // LDR r6, [r7]
                              0xBF30, 0xE7FE});  // WFI
    for (const std::uint32_t place : {TARGET, BUS}) {
        bench.core.set_reg(7, place);
        EXPECT_EQ(run_from(TARGET | THUMB), 5u);
        EXPECT_EQ(run_from((TARGET + 4) | THUMB), 4u);
        EXPECT_EQ(run_from(TARGET | THUMB), 5u);
    }
}

// ---- A breakpoint -------------------------------------------------------------------------------

struct Breakpoint final : sim::ArmProbe {
    bool before(std::uint32_t pc) override {
        met.push_back(pc);
        return false;
    }
    std::vector<std::uint32_t> met;
};

TEST_F(ReplacedLoop, KeepsABreakpointUntilTheProbeIsDetached) {
    Breakpoint breakpoint;
    bench.core.attach(&breakpoint, {AT});
    expect(2, 2);
    bench.put(AT, {ADD_16});
    expect(2, 32);
    EXPECT_THAT(breakpoint.met, ElementsAre(AT, AT, AT, AT));
    bench.core.attach(static_cast<sim::ArmProbe*>(nullptr));
    expect(2, 32);
    bench.put(AT, {ADD_1});
    expect(2, 2);
    EXPECT_EQ(breakpoint.met.size(), 4u);
}

}  // namespace replaced_code
