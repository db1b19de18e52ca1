// lamp_test.cpp - what a person sees of lamps that stand still, are dimmed and multiplexed.
#include "sim/board/lamp.h"

#include <gtest/gtest.h>

namespace {

constexpr std::uint64_t MS = 1'000'000'000;

class Lamp : public ::testing::Test {
protected:
    unsigned reported = 0;
    sim::LampBank bank{2, [this](std::uint64_t) { ++reported; }};

    void light(bool lit, std::uint64_t time_ps) {
        bank.pass(time_ps);
        bank.light(0, lit);
        bank.show();
    }
    // Lit for a part of each period, from `begin_ps` to `end_ps`.
    void dim(std::uint64_t lit_ps, std::uint64_t period_ps, std::uint64_t begin_ps,
             std::uint64_t end_ps) {
        for (std::uint64_t now = begin_ps; now < end_ps; now += period_ps) {
            light(true, now);
            light(false, now + lit_ps);
        }
        bank.pass(end_ps);
    }
};

TEST_F(Lamp, IsSeenAtOnceWhereItChangesNowAndThen) {
    light(true, 100 * MS);
    EXPECT_TRUE(bank.seen(0));
    EXPECT_FALSE(bank.seen(1));
    light(false, 101 * MS);
    EXPECT_FALSE(bank.seen(0));
    light(true, 102 * MS);
    EXPECT_TRUE(bank.seen(0));
    bank.pass(1000 * MS);
    EXPECT_TRUE(bank.seen(0));
    EXPECT_EQ(bank.brightness(0), 1);
    EXPECT_EQ(bank.brightness(1), 0);
    EXPECT_EQ(reported, 3u);
}

TEST_F(Lamp, IsSeenLitWhileItIsDimmed) {
    dim(MS / 10, MS, 20 * MS, 40 * MS);
    reported = 0;
    dim(MS / 10, MS, 40 * MS, 500 * MS);
    EXPECT_TRUE(bank.seen(0));
    EXPECT_NEAR(bank.brightness(0), 0.1, 0.01);
    EXPECT_EQ(reported, 0u) << "nothing new was seen";
}

TEST_F(Lamp, IsDarkBelowATwentieth) {
    dim(MS / 25, MS, 20 * MS, 100 * MS);
    EXPECT_FALSE(bank.seen(0));
    dim(MS / 16, MS, 100 * MS, 200 * MS);
    EXPECT_TRUE(bank.seen(0));
}

TEST_F(Lamp, IsSeenLitAtOnceIfDimmedFromPowerOn) {
    dim(MS / 10, MS, 0, 4 * MS);
    EXPECT_TRUE(bank.seen(0));
}

TEST_F(Lamp, GoesOutWithin40MsOfItsLastFlash) {
    dim(MS / 2, MS, 20 * MS, 100 * MS);
    EXPECT_TRUE(bank.seen(0));
    bank.pass(140 * MS);
    EXPECT_FALSE(bank.seen(0));
    EXPECT_EQ(bank.brightness(0), 0);
}

TEST_F(Lamp, HasFullBrightnessAfterALongRest) {
    light(true, 10 * MS);
    light(false, 1005 * MS);  // 1000 ms begin a span
    EXPECT_NEAR(bank.brightness(0), 1, 1e-9);
    bank.pass(1020 * MS);
    EXPECT_NEAR(bank.brightness(0), 0.25, 1e-9);
}

TEST_F(Lamp, TakesATimeBeforeTheLastForTheLast) {
    light(true, 10 * MS);
    bank.pass(12 * MS);
    light(false, 11 * MS);
    light(true, 12 * MS);
    bank.pass(20 * MS);
    EXPECT_NEAR(bank.brightness(0), 10.0 / 20, 1e-9);
}

}  // namespace
