// audio_clock_test.cpp - XCK, the audio block's clock and its reset, on the board
#include <gtest/gtest.h>

#include <array>

#include "Vaudio_clock_bench.h"
#include "tb/support/random_registers.h"

namespace {

constexpr std::array<unsigned, 2> DIVIDER{12, 2};  // 12.288 MHz to 128 * 8,000 and 128 * 48,000

class AudioClock : public ::testing::Test {
protected:
    Vaudio_clock_bench dut;
    unsigned pulses = 0;
    std::array<unsigned, 2> rises{};  // of clk_o

    static void SetUpTestSuite() { tb::start_with_random_registers(); }
    void SetUp() override {
        dut.pll_i = dut.locked_i = dut.rst_ni = 0;
        dut.eval();
    }
    void level(bool high) {
        const unsigned before = dut.clk_o;
        dut.pll_i = high;
        dut.eval();
        EXPECT_EQ(dut.xck_o, high ? 3 : 0);
        for (unsigned n = 0; n < 2; ++n) rises[n] += dut.clk_o & ~before & 1u << n ? 1 : 0;
    }
    void pulse(unsigned count = 1) {
        for (; count > 0; --count, ++pulses) {
            level(true);
            level(false);
        }
    }
    bool in_reset(unsigned n) const { return dut.rst_o >> n & 1; }
};

TEST_F(AudioClock, GivesXckAndItsFractionsInAResetToo) {
    for (const bool runs : {false, true, false}) {
        dut.rst_ni = dut.locked_i = runs;
        for (unsigned i = 0; i < 20; ++i) {
            const std::array<unsigned, 2> before = rises;
            pulse(12);
            EXPECT_EQ(rises[0] - before[0], 12 / DIVIDER[0]);
            EXPECT_EQ(rises[1] - before[1], 12 / DIVIDER[1]);
        }
    }
}

TEST_F(AudioClock, HasEqualPulsesInBothHalves) {
    std::array<unsigned, 2> high{};
    for (unsigned i = 0; i < 120; ++i) {
        pulse();
        for (unsigned n = 0; n < 2; ++n) high[n] += dut.clk_o >> n & 1;
    }
    EXPECT_EQ(high[0], 60u);
    EXPECT_EQ(high[1], 60u);
}

TEST_F(AudioClock, EndsTheResetTwoClocksAfterTheLastCause) {
    for (const bool locked_last : {false, true}) {
        dut.locked_i = !locked_last;
        dut.rst_ni = locked_last;
        pulse(100);
        EXPECT_EQ(dut.rst_o, 3);
        dut.locked_i = dut.rst_ni = 1;
        rises = {};
        for (unsigned i = 0; i < 36; ++i) {
            pulse();
            for (unsigned n = 0; n < 2; ++n) EXPECT_EQ(in_reset(n), rises[n] < 2) << n << " " << i;
        }
        EXPECT_EQ(dut.rst_o, 0);
    }
}

TEST_F(AudioClock, BeginsTheResetWithoutAClock) {
    for (const bool unlocks : {false, true}) {
        dut.locked_i = dut.rst_ni = 1;
        pulse(100);
        EXPECT_EQ(dut.rst_o, 0);
        (unlocks ? dut.locked_i : dut.rst_ni) = 0;
        dut.eval();
        EXPECT_EQ(dut.rst_o, 3);
    }
}

}  // namespace
