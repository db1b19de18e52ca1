// sync_meter.cpp against pulses made here.
#include "sim/board/sync_meter.h"

#include <gtest/gtest.h>

#include <vector>

namespace {

using sim::SyncMeter;

class SyncMeterTest : public ::testing::Test {
protected:
    SyncMeter meter;
    std::uint64_t now = 0;
    std::vector<std::uint64_t> begins;

    void run(bool level, unsigned count) {
        if (meter.run(level, count)) begins.push_back(now);
        now += count;
    }
    void pulses(unsigned number, bool level, unsigned width = 96, unsigned period = 800) {
        for (unsigned i = 0; i < number; ++i) {
            run(level, width);
            run(!level, period - width);
        }
    }
};

TEST_F(SyncMeterTest, FindsWhereThePulsesOfEitherPolarityBegin) {
    for (const bool positive : {false, true}) {
        meter = {};
        begins.clear();
        now = 0;
        run(!positive, 300);
        pulses(3, positive);
        EXPECT_EQ(meter.positive(), positive);
        EXPECT_EQ(begins, (std::vector<std::uint64_t>{300, 1100, 1900})) << positive;
        EXPECT_EQ(meter.since_begin(), 800u);
    }
}

TEST_F(SyncMeterTest, CountsAPulseThatComesInSeveralRunsOnce) {
    run(true, 300);
    for (unsigned i = 0; i < 96; ++i) run(false, 1);
    run(true, 704);
    run(false, 1);
    EXPECT_EQ(begins, (std::vector<std::uint64_t>{300, 1100}));
    EXPECT_EQ(meter.edges(), 3u);
}

TEST_F(SyncMeterTest, FollowsAChangeOfPolarityWithinThreePeriods) {
    pulses(100, false);
    pulses(3, true);
    EXPECT_TRUE(meter.positive());
    begins.clear();
    const std::uint64_t from = now;
    pulses(2, true);
    EXPECT_EQ(begins, (std::vector<std::uint64_t>{from, from + 800}));
}

TEST_F(SyncMeterTest, IsNotMisledByAGlitchInAPulse) {
    pulses(10, true);
    run(true, 40);
    run(false, 1);
    run(true, 55);
    run(false, 704);
    EXPECT_TRUE(meter.positive());
    pulses(1, true);
    EXPECT_TRUE(meter.positive());
}

TEST_F(SyncMeterTest, SeesNothingInALevelThatStays) {
    run(true, 1'000'000);
    run(true, 1'000'000);
    EXPECT_EQ(meter.edges(), 0u);
    EXPECT_TRUE(begins.empty());
}

}  // namespace
