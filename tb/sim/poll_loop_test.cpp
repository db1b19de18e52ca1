// poll_loop_test.cpp - which loops wait for a register, and how long they may rest
#include "sim/cpu/poll_loop.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "regmap.h"
#include "sim/chip/computer.h"

namespace {

using sim::PollLoop;

constexpr std::uint64_t NS = 1'000, US = 1'000'000;
constexpr std::uint32_t STATUS = 0xFF203028, PS2 = 0xFF200100, LEDR = 0xFF200000;

struct Access {
    char kind;  // Read or Write; or Other
    std::uint32_t pc, address, value;
};

// A program whose accesses take 200 ns each, and what it rests.
class PollLoopTest : public testing::Test {
protected:
    PollLoop loop;
    std::uint64_t now = 0, longest_rest = 0;
    unsigned accesses = 0, rests = 0;

    void go(const Access& access) {
        now += 200 * NS;
        ++accesses;
        std::uint64_t rest = 0;
        if (access.kind == 'R') rest = loop.read(access.pc, access.address, access.value, now);
        if (access.kind == 'W') rest = loop.write(access.pc, access.address, access.value, now);
        if (access.kind == 'O') loop.end();
        rests += rest > 0;
        longest_rest = std::max(longest_rest, rest);
        now += rest;
    }
    void repeat(const std::vector<Access>& round, std::uint64_t until) {
        while (now < until)
            for (const Access& access : round) go(access);
    }
};

TEST_F(PollLoopTest, RestsAnEighthOfTheTimeWaitedAndTenMicrosecondsAtMost) {
    repeat({{'R', 4, STATUS, 1}}, 1600 * NS);
    EXPECT_EQ(rests, 0u) << "not in the first eight rounds";
    while (now < 1000 * US) {
        const std::uint64_t before = now;
        go({'R', 4, STATUS, 1});
        const std::uint64_t rested = now - before - 200 * NS, waited = before;
        EXPECT_LE(rested, waited / 8);
        EXPECT_LE(rested, 10 * US);
    }
    EXPECT_EQ(longest_rest, 10 * US);
    EXPECT_LT(accesses, 170u);
    EXPECT_EQ(loop.polled(), STATUS);
}

TEST_F(PollLoopTest, BeginsToWaitAnewWhenTheValueChanges) {
    repeat({{'R', 4, STATUS, 1}}, 1000 * US);
    go({'R', 4, STATUS, 0});
    longest_rest = 0;
    repeat({{'R', 4, STATUS, 0}}, now + 3 * US);
    EXPECT_LT(longest_rest, US);
}

TEST_F(PollLoopTest, RestsTenthsOfMicrosecondsOnARunningCounter) {
    for (std::uint32_t i = 0; i < 1000; ++i) go({'R', 4, STATUS, i});
    EXPECT_GT(rests, 980u);
    EXPECT_EQ(longest_rest, 100 * NS);
}

TEST_F(PollLoopTest, KnowsLoopsThatAskSeveralRegisters) {
    go({'R', 0, LEDR, 0});  // on the way to it
    repeat({{'R', 4, STATUS, 1}, {'R', 8, PS2, 0}, {'R', 12, LEDR, 7}}, 1000 * US);
    EXPECT_EQ(longest_rest, 10 * US);
    EXPECT_LT(accesses, 500u);
}

TEST_F(PollLoopTest, RestsOnceARound) {
    repeat({{'R', 4, STATUS, 1}, {'R', 8, PS2, 0}}, 1000 * US);
    EXPECT_LE(rests, accesses / 2);
}

TEST_F(PollLoopTest, WaitsAnewWhenOneOfSeveralValuesChanges) {
    const std::vector<Access> before{{'R', 4, STATUS, 1}, {'R', 8, PS2, 0}},
        after{{'R', 4, STATUS, 1}, {'R', 8, PS2, 5}};
    repeat(before, 1000 * US);
    for (const Access& access : after) go(access);
    longest_rest = 0;
    repeat(after, now + 3 * US);
    EXPECT_LT(longest_rest, US);
}

TEST_F(PollLoopTest, FollowsOutputsThatKeepTheirValue) {
    repeat({{'R', 4, STATUS, 1}, {'W', 8, LEDR, 1}}, 1000 * US);
    EXPECT_EQ(longest_rest, 10 * US);
    EXPECT_EQ(loop.polled(), STATUS);
}

TEST_F(PollLoopTest, LeavesAloneWhatMovesAPin) {
    repeat({{'R', 4, STATUS, 1}, {'W', 8, LEDR, 1}, {'W', 12, LEDR, 0}}, 1000 * US);
    for (std::uint32_t i = 0; i < 1000; ++i) {
        go({'R', 4, STATUS, i});
        go({'W', 8, LEDR, i});
    }
    EXPECT_EQ(rests, 0u);
    EXPECT_FALSE(loop.polled());
}

TEST_F(PollLoopTest, LeavesAloneWhatOnlyWrites) {
    repeat({{'W', 8, LEDR, 1}}, 1000 * US);
    EXPECT_EQ(rests, 0u);
}

TEST_F(PollLoopTest, LeavesAloneWhatDoesSomethingElse) {
    repeat({{'R', 4, STATUS, 1}, {'O', 0, 0, 0}}, 1000 * US);
    EXPECT_EQ(rests, 0u);
}

TEST_F(PollLoopTest, LeavesAloneLoopsOverMoreRegistersThanItKeeps) {
    std::vector<Access> round;
    for (std::uint32_t i = 0; i <= PollLoop::MOST; ++i)
        round.push_back({'R', 4, STATUS + 4 * i, 1});
    repeat(round, 100 * US);
    EXPECT_EQ(rests, 0u);
    round.pop_back();
    repeat(round, now + 100 * US);
    EXPECT_GT(rests, 0u);
}

TEST(PlainOutput, IsAPortButNotACapturedEdgeThatIsCleared) {
    EXPECT_TRUE(sim::is_plain_output(regmap::LEDR_DATA, 0x3FF));
    EXPECT_TRUE(sim::is_plain_output(regmap::HEX5_4_DATA, 0x3F));
    EXPECT_TRUE(sim::is_plain_output(regmap::JP1_DIR, 0xF0));
    EXPECT_TRUE(sim::is_plain_output(sim::Peripherals::GPIO1_BASE, 1 << 24));
    EXPECT_TRUE(sim::is_plain_output(regmap::KEY_EDGE, 0));
    EXPECT_FALSE(sim::is_plain_output(regmap::KEY_EDGE, 0xF));
    EXPECT_FALSE(sim::is_plain_output(regmap::AUDIO_LEFTDATA, 0));
    EXPECT_FALSE(sim::is_plain_output(regmap::SYSID_ID, 0));
}

}  // namespace
