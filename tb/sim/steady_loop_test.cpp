// steady_loop_test.cpp - which rounds of a loop are alike, for how long, and what they leave
#include "sim/cpu/steady_loop.h"

#include <gtest/gtest.h>

#include <cstring>
#include <map>
#include <vector>

namespace {

using sim::SteadyLoop;

constexpr std::uint32_t CODE = 0x1000, DATA = 0x8000, KEY = 0xFF200050, TIMER = 0xFFFEC200;

// A program of a few words, 64 bytes of memory, and registers on the bus that keep their values.
class SteadyLoopTest : public testing::Test, private SteadyLoop::World {
protected:
    std::vector<std::uint32_t> program;
    std::uint8_t memory[64] = {};
    std::map<std::uint32_t, std::uint32_t> on_bus;
    sim::RunningCount timer{};  // at TIMER, as the first instruction begins
    std::optional<SteadyLoop::World::Cycles> cycle_counter;  // of the first instruction
    SteadyLoop::Registers now{{}, 0x13};
    SteadyLoop loop;

    bool steady(const std::vector<std::uint32_t>& words) {
        program = words;
        now.r[15] = CODE;
        return loop.follow(now, *this);
    }
    bool steady_thumb(const std::vector<std::uint16_t>& halves) {
        now.cpsr |= 1 << 5;
        std::vector<std::uint32_t> words;
        for (std::size_t i = 0; i < halves.size(); ++i) {
            const std::uint32_t next = i + 1 < halves.size() ? halves[i + 1] : 0;
            words.push_back(halves[i] < 0xE800 ? halves[i] : std::uint32_t{halves[i]} << 16 | next);
        }
        return steady(words);
    }
    void set(std::uint32_t word, unsigned offset = 0) { std::memcpy(memory + offset, &word, 4); }

private:
    std::optional<std::uint32_t> code(std::uint32_t pc, bool thumb) override {
        const std::uint32_t index = (pc - CODE) / (thumb ? 2 : 4);
        return index < program.size() ? std::optional{program[index]} : std::nullopt;
    }
    Place place(std::uint32_t address, bool) override {
        if (address - DATA < sizeof memory) return {memory + (address - DATA), false, 0};
        return {nullptr, address >= 0xFF200000, address};
    }
    std::optional<std::uint32_t> answer(const SteadyLoop::Use& use) override {
        const auto found = on_bus.find(use.address);
        if (found == on_bus.end() || (use.write && found->second != use.value)) return std::nullopt;
        return found->second;
    }
    // An instruction takes 1 ns, an access 10 ns more.
    std::optional<sim::RunningCount> counter(const SteadyLoop::Use* uses, unsigned count) override {
        if (uses[count - 1].address != TIMER) return std::nullopt;
        sim::RunningCount then = timer;
        const std::uint64_t passed = round_ps(uses, count, uses[count - 1].at);
        const std::uint64_t steps = (timer.phase_ps + passed) / timer.tick_ps;
        then.value += static_cast<std::uint32_t>(timer.sign < 0 ? 0 - steps : steps);
        then.phase_ps = (timer.phase_ps + passed) % timer.tick_ps;
        if (timer.left_ps != sim::RunningCount::FOR_EVER) then.left_ps -= passed;
        return then;
    }
    std::uint64_t round_ps(const SteadyLoop::Use*, unsigned count, unsigned instructions) override {
        return 1000 * instructions + 10'000 * count;
    }
    std::optional<Cycles> cycles(unsigned at) override {
        if (!cycle_counter) return std::nullopt;
        return Cycles{cycle_counter->value + (at - 1) * cycle_counter->step, cycle_counter->step};
    }
};

TEST_F(SteadyLoopTest, GoesOnForEverWhereNothingChanges) {
    EXPECT_TRUE(steady({0xEAFFFFFE}));  // b .
    EXPECT_EQ(loop.instructions(), 1u);
    EXPECT_EQ(loop.rounds(), sim::ALL_ROUNDS);
    now.r[14] = CODE;
    EXPECT_TRUE(steady({0xE12FFF1E}));  // bx lr
    EXPECT_EQ(loop.rounds(), sim::ALL_ROUNDS);
}

TEST_F(SteadyLoopTest, EndsAFlagsLoopNever) {
    now.r[3] = DATA;
    EXPECT_TRUE(steady({0xE5932000, 0xE3520000, 0x0AFFFFFC}));  // ldr r2, [r3]; cmp r2, #0; beq
    EXPECT_EQ(loop.rounds(), sim::ALL_ROUNDS);
    set(1);
    EXPECT_FALSE(steady({0xE5932000, 0xE3520000, 0x0AFFFFFC})) << "it ends now";
}

TEST_F(SteadyLoopTest, CountsRegistersDownToZero) {
    now.r[1] = 1000;
    EXPECT_TRUE(steady({0xE2511001, 0x1AFFFFFD}));  // subs r1, r1, #1; bne
    EXPECT_EQ(loop.rounds(), 999u) << "the thousandth goes on";
    EXPECT_EQ(loop.after(999).r[1], 1u);
}

TEST_F(SteadyLoopTest, CountsInMemory) {
    now.r[13] = DATA;
    now.r[2] = 999'999;
    // ldr r3, [sp, #4]; add r3, r3, #1; str r3, [sp, #4]; ldr r3, [sp, #4]; cmp r3, r2; ble
    const std::vector<std::uint32_t> delay{0xE59D3004, 0xE2833001, 0xE58D3004,
                                           0xE59D3004, 0xE1530002, 0xDAFFFFF9};
    set(10, 4);
    now.r[3] = 10;
    ASSERT_TRUE(steady(delay));
    EXPECT_EQ(loop.rounds(), 999'999u - 10);
    ASSERT_EQ(loop.word_count(), 1u);
    EXPECT_EQ(loop.words()[0].address, DATA + 4);
    EXPECT_EQ(loop.words()[0].value.step, 1u);
}

TEST_F(SteadyLoopTest, EndsBeforeACounterPassesItsLimitInSteps) {
    now.r[1] = 0;
    now.r[2] = 100;
    EXPECT_TRUE(steady({0xE2811007, 0xE1510002, 0x3AFFFFFC}));  // add r1, #7; cmp r1, r2; bcc
    EXPECT_EQ(loop.rounds(), 14u) << "98 is below 100, 105 is not";
    now.r[1] = 0xFFFFFFF0;  // -16
    EXPECT_TRUE(steady({0xE2811007, 0xE1510002, 0xBAFFFFFC})) << "blt, signed";
    EXPECT_EQ(loop.rounds(), 16u) << "96 is below 100";
}

TEST_F(SteadyLoopTest, KnowsWhatTheBusAnswers) {
    now.r[0] = KEY;
    const std::vector<std::uint32_t> seed{0xE5901000, 0xE2822001, 0xE3510000, 0x0AFFFFFB};
    EXPECT_FALSE(steady(seed)) << "not what it does not know";  // ldr; add r2, #1; cmp r1, #0; beq
    on_bus[KEY] = 0;
    ASSERT_TRUE(steady(seed));
    EXPECT_EQ(loop.rounds(), sim::ALL_ROUNDS);
    EXPECT_EQ(loop.after(5).r[2], 5u);
    ASSERT_EQ(loop.use_count(), 1u);
    EXPECT_EQ(loop.uses()[0].address, KEY);
    EXPECT_EQ(loop.uses()[0].at, 1u);
}

TEST_F(SteadyLoopTest, WritesTheSameToTheBusAlone) {
    now.r[0] = KEY;
    now.r[1] = 7;
    on_bus[KEY] = 7;
    EXPECT_TRUE(steady({0xE5801000, 0xEAFFFFFD}));  // str r1, [r0]; b
    EXPECT_FALSE(steady({0xE5801000, 0xE2811001, 0xEAFFFFFC})) << "it counts";
}

TEST_F(SteadyLoopTest, FollowsCallsAndTheirStack) {
    now.r[13] = DATA + 32;
    now.r[14] = CODE + 4;
    // bl f; b .-4; f: push {r4, lr}; pop {r4, pc}
    set(0, 24);
    set(CODE + 4, 28);
    EXPECT_TRUE(steady({0xEB000000, 0xEAFFFFFD, 0xE92D4010, 0xE8BD8010}));
    EXPECT_EQ(loop.instructions(), 4u);
}

TEST_F(SteadyLoopTest, LeavesAloneWhatItDoesNotKnow) {
    now.r[1] = DATA;
    EXPECT_FALSE(steady({0xE4912004, 0xEAFFFFFD})) << "ldr r2, [r1], #4: the address grows";
    EXPECT_FALSE(steady({0xE1A02082, 0xE2822001, 0xEAFFFFFC})) << "r2 = 2 r2 + 1";
    EXPECT_FALSE(steady({0xEE193F1D, 0xEAFFFFFD})) << "a cycle counter that may not be read";
    now.r[14] = CODE + 1;
    EXPECT_FALSE(steady({0xE12FFF1E})) << "bx lr, to Thumb";
    now.r[14] = CODE;
    EXPECT_FALSE(steady_thumb({0x4770})) << "bx lr, to ARM";
}

TEST_F(SteadyLoopTest, ReadsThumbAsItReadsArm) {
    EXPECT_TRUE(steady_thumb({0xE7FE}));  // b .
    EXPECT_EQ(loop.rounds(), sim::ALL_ROUNDS);
    now.r[14] = CODE | 1;
    EXPECT_TRUE(steady_thumb({0x4770}));  // bx lr
    now.r[3] = DATA;
    EXPECT_TRUE(steady_thumb({0x681A, 0x2A00, 0xD0FC}));  // ldr r2, [r3]; cmp r2, #0; beq
    now.r[13] = DATA;
    now.r[2] = 999'999;
    // ldr r3, [sp, #4]; adds r3, #1; str r3, [sp, #4]; ldr r3, [sp, #4]; cmp r3, r2; ble
    set(10, 4);
    ASSERT_TRUE(steady_thumb({0x9B01, 0x3301, 0x9301, 0x9B01, 0x4293, 0xDDF9}));
    EXPECT_EQ(loop.instructions(), 6u);
    EXPECT_EQ(loop.rounds(), 999'999u - 10);
    EXPECT_EQ(loop.word_after(0, 5), 15u);
}

TEST_F(SteadyLoopTest, ReadsThumbsLongInstructionsAndCalls) {
    now.r[0] = KEY;
    on_bus[KEY] = 0x10;
    // ldr.w r1, [r0]; add.w r2, r2, #0x10001; tst.w r1, #15; beq.w
    ASSERT_TRUE(steady_thumb({0xF8D0, 0x1000, 0xF102, 0x1201, 0xF011, 0x0F0F, 0xF43F, 0xAFF8}));
    EXPECT_EQ(loop.instructions(), 4u);
    EXPECT_EQ(loop.after(3).r[2], 0x30003u);
    now.r[13] = DATA + 32;
    now.r[14] = CODE + 5;
    set(CODE + 5, 28);
    // bl f; b .-4; f: push {r4, lr}; pop {r4, pc}
    EXPECT_TRUE(steady_thumb({0xF000, 0xF801, 0xE7FC, 0xB510, 0xBD10}));
    EXPECT_EQ(loop.instructions(), 4u);
}

TEST_F(SteadyLoopTest, EndsAThumbLoopByItsItBlockOrCbz) {
    now.r[1] = 100;
    // subs r1, #1; cmp r1, #10; it eq; moveq r4, #7; cbz r1, out; b
    const std::vector<std::uint16_t> delay{0x3901, 0x290A, 0xBF08, 0x2407, 0xB101, 0xE7F9};
    ASSERT_TRUE(steady_thumb(delay));
    EXPECT_EQ(loop.instructions(), 6u) << "also the one that is not executed";
    EXPECT_EQ(loop.rounds(), 89u);
    now.r[1] = 10;
    ASSERT_TRUE(steady_thumb(delay));
    EXPECT_EQ(loop.rounds(), 9u);
}

TEST_F(SteadyLoopTest, FollowsACounterThatRunsInTime) {
    now.r[0] = TIMER;
    now.r[1] = 1000;
    now.r[2] = 50;
    timer = {1000, 1, 5000, 0};
    // ldr r3, [r0]; sub r3, r3, r1; cmp r3, r2; bcc: 14 ns a round, read after 11
    const std::vector<std::uint32_t> wait{0xE5903000, 0xE0433001, 0xE1530002, 0x3AFFFFFB};
    ASSERT_TRUE(steady(wait));
    EXPECT_EQ(loop.rounds(), 18u) << "11 + 17 * 14 ns are 49 ticks and 4 ns, 14 ns more are 52";
    EXPECT_EQ(loop.after(1).r[3], 2u);
    EXPECT_EQ(loop.after(18).r[3], 49u) << "what it read last, before the present round";
    timer = {1000, -1, 5000, 0, 100'000};
    now.r[2] = 0;
    EXPECT_TRUE(steady({0xE5903000, 0xE1530002, 0x1AFFFFFC}));  // ldr r3, [r0]; cmp r3, r2; bne
    EXPECT_EQ(loop.rounds(), 7u) << "then it reloads: 11 + 6 * 13 ns, 11 + 7 * 13 ns";
}

TEST_F(SteadyLoopTest, FollowsTheCycleCounter) {
    now.r[1] = 5000;
    now.r[2] = 100;
    cycle_counter = {5000, 1};
    // mrc p15, 0, r3, c9, c13, 0; sub r3, r3, r1; cmp r3, r2; bcc
    ASSERT_TRUE(steady({0xEE193F1D, 0xE0433001, 0xE1530002, 0x3AFFFFFB}));
    EXPECT_EQ(loop.rounds(), 25u);
    EXPECT_EQ(loop.after(25).r[3], 96u);
}

TEST_F(SteadyLoopTest, KeepsWhatIsReadBeforeItIsWritten) {
    now.r[0] = TIMER;
    timer = {1000, 1, 5000, 0};
    // add r4, r4, r3; ldr r3, [r0]; b: the sum of what it has read
    EXPECT_FALSE(steady({0xE0844003, 0xE5903000, 0xEAFFFFFC}));
}

TEST_F(SteadyLoopTest, NamesAPlaceAheadWhereFlagsAreNotKnown) {
    now.r[3] = DATA;
    EXPECT_FALSE(steady({0x0A000000, 0xE1A00000, 0xE1A00000}));  // beq
    EXPECT_EQ(loop.ahead(), 1u);
}

}  // namespace
