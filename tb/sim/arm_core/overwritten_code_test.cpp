// Code that the program itself overwrites: from the next instruction on the new ones are executed,
// with and without cache maintenance, and each is counted once.
//
// An ARMv7-A program must clean and invalidate (B2.2.7, B3.10); the model needs none of it.
#include <gmock/gmock.h>

#include <algorithm>
#include <array>
#include <ctime>

#include "tb/sim/arm_core/bench.h"

namespace overwritten_code {

using namespace tb::core;
using sim::ArmStop;

constexpr std::uint32_t NOP = 0xE320F000, WFI = 0xE320F003;
constexpr std::uint32_t ADD_1 = 0xE2800001;  // ADD r0, r0, #1
constexpr unsigned LAPS = 10;

class OverwrittenCode : public ::testing::Test {
protected:
    OverwrittenCode() { bench.core.map_ram(TOP, 0x1000, top.data()); }

    static constexpr std::uint32_t TOP = 0xFFFFF000;

    // Runs `code` from `at` to its WFI, in one piece and then in smaller ones, with the address
    // that it is to overwrite in r1; what comes of it in r0.
    void expect(const std::vector<std::uint32_t>& code, std::uint32_t at, std::uint32_t overwritten,
                std::uint32_t result, std::uint64_t instructions) {
        for (const std::uint64_t piece : {1000u, 1u, 2u, 3u, 7u, 1000u}) {
            SCOPED_TRACE("in pieces of " + std::to_string(piece));
            bench.put(at, code);
            const auto word = [&](std::uint32_t address) { return code[(address - at) / 4]; };
            bench.core.set_cpsr(0x1D3);
            bench.core.set_reg(0, 0);
            bench.core.set_reg(1, overwritten);
            bench.core.set_reg(2, word(overwritten));
            bench.core.set_reg(3, word(overwritten + 4));
            bench.core.set_reg(4, LAPS);
            bench.core.set_reg(5, 0x11);  // from the one ADD to the other
            bench.core.set_reg(15, at);
            const std::uint64_t before = bench.core.instructions();
            ArmStop stop = ArmStop::LIMIT;
            while (stop == ArmStop::LIMIT && bench.core.instructions() - before < 1000) {
                const std::uint64_t now = bench.core.instructions();
                stop = bench.core.run(piece);
                ASSERT_LE(bench.core.instructions(), now + piece);
            }
            ASSERT_EQ(stop, ArmStop::WFI);
            ASSERT_EQ(bench.core.reg(0), result);
            ASSERT_EQ(bench.core.instructions() - before, instructions);
        }
    }

    alignas(4096) std::array<std::uint8_t, 4096> top{};
    Bench bench;
};

struct Store {
    const char* name;
    std::uint32_t words[2];
};
constexpr Store STORES[] = {
    {"STR", {NOP, 0xE5812000}},          // STR r2, [r1]
    {"STRB", {NOP, 0xE5C12000}},         // STRB r2, [r1]
    {"STRH", {NOP, 0xE1C120B0}},         // STRH r2, [r1]
    {"STRD", {NOP, 0xE1C120F0}},         // STRD r2, r3, [r1]
    {"STM", {NOP, 0xE881000C}},          // STM r1, {r2, r3}
    {"VSTR", {0xEE002A10, 0xED810A00}},  // VMOV s0, r2;      VSTR s0, [r1]
    {"VST1", {0xEC432B10, 0xF401078F}},  // VMOV d0, r2, r3;  VST1.32 {d0}, [r1]
    {"VSTM", {0xEC432B11, 0xEC811B02}},  // VMOV d1, r2, r3;  VSTM r1, {d1}
};
// In a page; over the end of one; at the end of all addresses.
constexpr std::uint32_t PLACES[] = {0x8000, 0x8FF0, 0x9FF4, 0xFFFFF000, 0xFFFFFFC0};

// A loop that overwrites a word of itself; half of the laps add 16 to r0, the other half 1.
struct Loop {
    const char* name;
    std::uint32_t overwritten;  // where, in bytes from the begin
    unsigned instructions;      // of a lap
    std::vector<std::uint32_t> code;
};
constexpr std::uint32_t STORE_1 = 1, STORE_2 = 2;  // its two instructions
constexpr std::uint32_t EOR = 0xE0222005;          // EOR r2, r2, r5: to the other word
constexpr std::uint32_t SUBS = 0xE2544001;         // SUBS r4, r4, #1
constexpr std::uint32_t B_NEXT = 0xEAFFFFFF;       // B to the next
const Loop LOOPS[] = {
    {"right after the store", 12, 6, {EOR, STORE_1, STORE_2, ADD_1, SUBS, 0x1AFFFFF9, WFI}},
    {"in the next block", 16, 7, {EOR, STORE_1, STORE_2, B_NEXT, ADD_1, SUBS, 0x1AFFFFF8, WFI}},
    {"in a block executed before",
     0,
     7,
     {ADD_1, B_NEXT, EOR, STORE_1, STORE_2, SUBS, 0x1AFFFFF8, WFI}},
    {"after cache maintenance",
     36,
     12,
     {EOR, STORE_1, STORE_2,
      0xEE071F3B,  // MCR p15, 0, r1, c7, c11, 1: DCCMVAU
      0xF57FF04F,  // DSB
      0xEE071F35,  // MCR p15, 0, r1, c7, c5, 1: ICIMVAU
      0xEE070FD5,  // MCR p15, 0, r0, c7, c5, 6: BPIALL
      0xF57FF04F,  // DSB
      0xF57FF06F,  // ISB
      ADD_1, SUBS, 0x1AFFFFF3, WFI}},
    {"a literal in the midst",
     32,
     7,
     {EOR, STORE_1, STORE_2,
      0xE59F600C,  // LDR r6, [pc, #12]
      0xE0800006,  // ADD r0, r0, r6
      SUBS, 0x1AFFFFF8, WFI, 1, 0}},
    {"the second half of a literal",  // a constant of its block if at a multiple of 8
     44,
     7,
     {EOR, STORE_1, STORE_2,
      0xE1CF61D4,  // LDRD r6, r7, [pc, #20]
      0xE0800007,  // ADD r0, r0, r7
      SUBS, 0x1AFFFFF8, WFI, 0, 0,
      0,  // at + 40
      1, 0}},
};

// Each loop is where no other has been translated: its own words alone are known to be code.
TEST_F(OverwrittenCode, IsNewForTheNextInstruction) {
    std::uint32_t apart = 0;
    for (const Loop& loop : LOOPS) {
        for (const Store& store : STORES)
            for (const std::uint32_t place : PLACES) {
                const std::uint32_t at = place < TOP ? place + apart : place;
                SCOPED_TRACE(testing::Message()
                             << loop.name << " by " << store.name << " at " << at);
                auto code = loop.code;
                std::replace(code.begin(), code.begin() + 5, STORE_1, store.words[0]);
                std::replace(code.begin(), code.begin() + 5, STORE_2, store.words[1]);
                expect(code, at, at + loop.overwritten, LAPS / 2 * (16 + 1),
                       loop.instructions * LAPS + 1);
            }
        apart += 0x4000;
    }
}

// A variable after a literal is none: to write it takes no new translation.
TEST_F(OverwrittenCode, IsNotTheVariableAfterALiteral) {
    const auto processor_time = [&](std::uint32_t variable) {
        bench.put(0x8000, {
                              0xE59F3008,  // LDR r3, [pc, #8]
                              0xE5813000,  // STR r3, [r1]
                              0xE2544001,  // SUBS r4, r4, #1
                              0x1AFFFFFB,  // BNE to the begin
                              0x8014,      // the literal
                              0,
                              0,
                              0,
                          });
        bench.core.set_reg(1, variable);
        bench.core.set_reg(4, ~0u);
        bench.core.set_reg(15, 0x8000);
        const std::clock_t begin = std::clock();
        bench.core.run(1'000'000);
        return static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
    };
    const double elsewhere = processor_time(0x8800);
    EXPECT_LT(processor_time(0x8014), 10 * elsewhere);
}

// A branch that the program has come close to, but has not executed, becomes a NOP.
TEST_F(OverwrittenCode, ChangesHowFarItIsToTheNextBranch) {
    bench.put(0x8000, {
                          NOP,
                          0xE5812000,  // STR r2, [r1]
                          NOP, NOP,
                          0xEAFFFFFE,  // B to itself
                      });
    std::vector<std::uint32_t> after(20, NOP);
    after.push_back(0xEAFFFFFE);
    bench.put(0x8014, after);
    bench.core.set_reg(1, 0x8010);
    bench.core.set_reg(2, NOP);
    bench.core.set_reg(15, 0x8000);
    for (const unsigned limit : {1, 1, 5}) ASSERT_EQ(bench.core.run(limit), ArmStop::LIMIT);
    EXPECT_EQ(bench.core.instructions(), 7u);
    EXPECT_EQ(bench.core.pc(), 0x801Cu);
}

}  // namespace overwritten_code
