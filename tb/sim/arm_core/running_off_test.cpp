// Programs leaving their code: into zeros, off the end of RAM, into devices, to where nothing is.
// run() ends there, with the pc and the count exact.
#include <gmock/gmock.h>

#include "tb/sim/arm_core/system_bench.h"

namespace running_off {

using namespace tb::core;
using sim::ArmStop;

constexpr Both BX_R1{0xE12FFF11, 0x4708};
constexpr unsigned SOME = 100;

class RunningOff : public SystemTest {
protected:
    unsigned bytes() const { return thumb() ? 2 : 4; }  // of each instruction here
    void expect(ArmStop stop, std::uint32_t from, std::uint32_t to, std::uint64_t instructions) {
        const std::uint64_t before = bench.core.instructions();
        set(15, from);
        for (unsigned again = 0; again < 3; ++again) {
            EXPECT_EQ(run(), stop);
            EXPECT_EQ(bench.core.pc(), to);
            EXPECT_EQ(bench.core.instructions() - before, instructions);
        }
        EXPECT_TRUE(bench.accesses.empty()) << "no code is asked of the bus";
    }
    void expect_abort(std::uint32_t from, std::uint32_t to, std::uint64_t instructions) {
        expect(ArmStop::PREFETCH_ABORT, from, to, instructions);
        EXPECT_EQ(bench.core.fault().address, to);
        EXPECT_FALSE(bench.core.fault().write);
        EXPECT_FALSE(bench.core.fault().mmu);
    }
};

// ---- Into zeros ---------------------------------------------------------------------------------

TEST_P(RunningOff, IntoZerosEndsAtTheFirst) {
    const std::uint32_t end = put(AT, std::vector<Both>(SOME, NOP));
    expect(ArmStop::RAN_OFF, AT, end, SOME);
    put(AT, {NOP, BX_R1});
    set(1, 0x20000 | (thumb() ? 1 : 0));
    expect(ArmStop::RAN_OFF, AT, 0x20000, 2);
}

// ANDEQ r0, r0, r0, and in Thumb MOVS r0, r0.
TEST_P(RunningOff, DoesNotTakeAFewZerosForTheEnd) {
    put(put(AT, {NOP}) + 60 * bytes(), {WFI, SPIN});
    set(15, AT);
    EXPECT_EQ(run(), ArmStop::WFI);
    EXPECT_EQ(bench.core.instructions(), 62u);
}

TEST_P(RunningOff, IsOverWhenCodeIsPutThere) {
    const std::uint32_t end = put(AT, {NOP, NOP});
    expect(ArmStop::RAN_OFF, AT, end, 2);
    put(end, {WFI, SPIN});
    EXPECT_EQ(run(), ArmStop::WFI);
    EXPECT_EQ(bench.core.instructions(), 3u);
}

// One instruction from the end, so that no block leads there.
TEST_P(RunningOff, IsNoticedAfterTheLastInstructionThatWasAskedFor) {
    const std::uint32_t end = put(AT, std::vector<Both>(SOME, NOP));
    set(15, AT);
    EXPECT_EQ(bench.core.run(SOME), ArmStop::LIMIT);
    EXPECT_EQ(bench.core.pc(), end);
    EXPECT_EQ(bench.core.run(1), ArmStop::RAN_OFF);
    EXPECT_EQ(bench.core.instructions(), SOME);
}

TEST_P(RunningOff, IsNoticedWithAProfiler) {
    struct Tally final : sim::ArmTally {
        void ran(const Run& run) override { instructions += run.instructions; }
        bool same_function(std::uint32_t, std::uint32_t) const override { return true; }
        std::uint64_t instructions = 0;
    } tally;
    bench.core.attach(&tally);
    const std::uint32_t end = put(AT, std::vector<Both>(SOME, NOP));
    expect(ArmStop::RAN_OFF, AT, end, SOME);
    EXPECT_EQ(tally.instructions, SOME);
}

// ---- Where no code can be -----------------------------------------------------------------------

TEST_P(RunningOff, TheEndOfRamAborts) {
    const std::uint32_t begin = RAM - SOME * bytes();
    expect_abort(begin, RAM, SOME);  // zeros
    put(begin, std::vector<Both>(SOME, NOP));
    expect_abort(begin, RAM, SOME);
}

TEST_P(RunningOff, IntoADeviceOrNowhereAborts) {
    for (const std::uint32_t place : {BUS + 0x10, REFUSED, NOTHING, 0xFFFFF000u}) {
        SCOPED_TRACE(place);
        put(AT, {NOP, BX_R1});
        set(1, place | (thumb() ? 1 : 0));
        expect_abort(AT, place, 2);
    }
}

// With a branch ahead, the way there is one block of translated code.
TEST_P(RunningOff, APageThatIsMappedNoLongerAborts) {
    std::vector<Both> code(SOME, NOP);
    code.push_back(SPIN);
    const std::uint32_t begin = 0x20000 - SOME / 2 * bytes();
    put(begin, code);
    for (unsigned i = 0; i < 3; ++i) {
        set(15, begin);
        EXPECT_EQ(run(), ArmStop::LIMIT);
    }
    bench.core.unmap(0, RAM);
    bench.core.map_ram(0, 0x20000, bench.memory());
    expect_abort(begin, 0x20000, SOME / 2);
}

INSTANTIATE_TEST_SUITE_P(In, RunningOff, EACH_WAY, name_of_way);

// The second half of an instruction is where RAM has ended.
TEST(RunningOffInThumb, InTheMidstOfAnInstructionAborts) {
    for (const unsigned limit : {1u, 1000u}) {
        Bench bench;
        bench.put_halves(RAM - 6, {0xBF00, 0xBF00, 0xF100});  // NOP; NOP; ADD.W
        bench.core.set_cpsr(SVC | T);
        bench.core.set_reg(15, RAM - 6);
        ArmStop stop = ArmStop::LIMIT;
        for (unsigned i = 0; i < 5 && stop == ArmStop::LIMIT; ++i) stop = bench.core.run(limit);
        EXPECT_EQ(stop, ArmStop::PREFETCH_ABORT);
        EXPECT_EQ(bench.core.pc(), RAM - 2);
        EXPECT_EQ(bench.core.fault().address, RAM);
        EXPECT_EQ(bench.core.instructions(), 2u);
    }
}

}  // namespace running_off
