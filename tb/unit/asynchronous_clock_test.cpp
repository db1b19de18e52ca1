// asynchronous_clock.h: where its edges lie, against fractions worked out by hand.
#include <gtest/gtest.h>

#include "sim/fpga/asynchronous_clock.h"

namespace {

using sim::AsynchronousClock;

constexpr std::uint64_t PS_PER_S = 1'000'000'000'000;

TEST(AudioClock, Rises128TimesPerSampleWithoutDrift) {
    for (const unsigned rate : {8'000u, 48'000u}) {
        AsynchronousClock clock = sim::audio_clock(rate);
        const std::uint64_t first = clock.time_ps();
        for (std::uint64_t rises = 0; rises < 60ull * 128 * rate; ++rises)
            clock.next(), clock.next();
        EXPECT_TRUE(clock.rises());
        EXPECT_EQ(clock.time_ps() - first, 60 * PS_PER_S);
    }
}

// 976.5625 and 162.76041666... ns.
TEST(AudioClock, KeepsItsPeriodWithinAPicosecond) {
    for (const unsigned rate : {8'000u, 48'000u}) {
        AsynchronousClock clock = sim::audio_clock(rate);
        const std::uint64_t first = clock.time_ps();
        for (std::uint64_t half = 0; half < 100'000; ++half, clock.next()) {
            const double exact = static_cast<double>(half) * PS_PER_S / (256.0 * rate);
            ASSERT_NEAR(static_cast<double>(clock.time_ps() - first), exact, 1) << half;
            ASSERT_EQ(clock.rises(), half % 2 == 0);
        }
    }
}

TEST(AudioClock, IsLowForItsFirstPeriod) {
    EXPECT_NEAR(static_cast<double>(sim::audio_clock(8'000).time_ps()), 976'562.5, 100);
    EXPECT_NEAR(static_cast<double>(sim::audio_clock(48'000).time_ps()), 162'760.4, 100);
}

TEST(AudioClock, NeverMovesTogetherWithTheFabricsClock) {
    for (const unsigned rate : {8'000u, 48'000u}) {
        AsynchronousClock clock = sim::audio_clock(rate);
        for (int i = 0; i < 100'000; ++i, clock.next())
            ASSERT_NE(clock.time_ps() % (sim::FABRIC_PERIOD_PS / 2), 0u) << i;
    }
}

TEST(AudioClock, ReportsInWhichHalfOfAClockItMoves) {
    AsynchronousClock clock = sim::audio_clock(48'000);
    for (int i = 0; i < 10'000; ++i, clock.next()) {
        const std::uint64_t half = clock.time_ps() / (sim::FABRIC_PERIOD_PS / 2);
        ASSERT_FALSE(clock.before(half));
        ASSERT_TRUE(clock.before(half + 1));
    }
}

TEST(DecoderClock, NeverRisesWithTheFabricsClock) {
    AsynchronousClock clock = sim::decoder_clock();
    const std::uint64_t first = clock.time_ps();
    for (std::uint64_t half = 0; half < 540'000; ++half, clock.next()) {
        const double exact = static_cast<double>(half) * PS_PER_S / 54e6;
        ASSERT_NEAR(static_cast<double>(clock.time_ps() - first), exact, 1) << half;
        ASSERT_NE(clock.time_ps() % (sim::FABRIC_PERIOD_PS / 2), 0u) << half;
        ASSERT_EQ(clock.number(), half / 2);
    }
    EXPECT_EQ(clock.time_ps() - first, PS_PER_S / 100);
}

// As if it had gone there edge by edge.
TEST(DecoderClock, SkipsToTheFirstRiseAfterAClock) {
    AsynchronousClock steps = sim::decoder_clock();
    for (std::uint64_t clocks = 0; clocks < 5'000; ++clocks) {
        while (steps.clocks() < clocks || !steps.rises()) steps.next();
        AsynchronousClock skips = sim::decoder_clock();
        skips.skip_to(clocks);
        ASSERT_EQ(skips.time_ps(), steps.time_ps()) << clocks;
        ASSERT_EQ(skips.number(), steps.number()) << clocks;
        ASSERT_TRUE(skips.rises());
    }
}

}  // namespace
