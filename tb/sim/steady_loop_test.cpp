// steady_loop_test.cpp - which rounds of a loop are alike, for how long, and what they leave
#include "sim/cpu/steady_loop.h"

#include <gtest/gtest.h>

#include <cstring>
#include <map>
#include <vector>

namespace {

using sim::SteadyLoop;

constexpr std::uint32_t CODE = 0x1000, DATA = 0x8000, KEY = 0xFF200050;

// A program of a few words, 64 bytes of memory, and registers on the bus that keep their values.
class SteadyLoopTest : public testing::Test, private SteadyLoop::World {
protected:
    std::vector<std::uint32_t> program;
    std::uint8_t memory[64] = {};
    std::map<std::uint32_t, std::uint32_t> on_bus;
    SteadyLoop::Registers now{{}, 0x13};
    SteadyLoop loop;

    bool steady(const std::vector<std::uint32_t>& words) {
        program = words;
        now.r[15] = CODE;
        return loop.follow(now, *this);
    }
    void set(std::uint32_t word, unsigned offset = 0) { std::memcpy(memory + offset, &word, 4); }

private:
    std::optional<std::uint32_t> code(std::uint32_t pc) override {
        const std::uint32_t index = (pc - CODE) / 4;
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
    EXPECT_FALSE(steady({0xEE193F1D, 0xEAFFFFFD})) << "the cycle counter";
    now.cpsr |= 1 << 5;
    EXPECT_FALSE(steady({0xEAFFFFFE})) << "Thumb";
}

TEST_F(SteadyLoopTest, NamesAPlaceAheadWhereFlagsAreNotKnown) {
    now.r[3] = DATA;
    EXPECT_FALSE(steady({0x0A000000, 0xE1A00000, 0xE1A00000}));  // beq
    EXPECT_EQ(loop.ahead(), 1u);
}

}  // namespace
