// app_bounce_test.cpp - collisions against the textbook's formulas, and the arithmetic below them.
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <set>

#include "app/bounce.h"
#include "app/random.h"
#include "app/sine.h"

namespace {

using namespace app;
using collision::PIXEL;
using collision::Vec2;

Body body(unsigned size, double x, double y, double vx, double vy) {
    Body made;
    made.size = size;
    made.position = {static_cast<std::int32_t>(x * PIXEL), static_cast<std::int32_t>(y * PIXEL)};
    made.velocity = {static_cast<std::int32_t>(vx * PIXEL_PER_TICK),
                     static_cast<std::int32_t>(vy * PIXEL_PER_TICK)};
    return made;
}

double energy(const Body& b) {
    return b.size * b.size * (std::pow(b.velocity.x, 2) + std::pow(b.velocity.y, 2));
}

TEST(Bounce, ExchangesTheVelocitiesOfEqualBodiesHeadOn) {
    Body a = body(16, 100, 50, 1, 0.25), b = body(16, 110, 50, -0.5, 0);
    bounce(a, b);
    EXPECT_EQ(a.velocity, (Vec2{-PIXEL_PER_TICK / 2, PIXEL_PER_TICK / 4}));
    EXPECT_EQ(b.velocity, (Vec2{PIXEL_PER_TICK, 0}));
}

TEST(Bounce, ThrowsTheLightBackFromTheHeavy) {
    Body light = body(12, 100, 50, 1, 0), heavy = body(20, 110, 50, 0, 0);
    bounce(light, heavy);  // (144 - 400) / 544 and 2 * 144 / 544 of what came in
    EXPECT_NEAR(light.velocity.x, -7895160, 1);
    EXPECT_NEAR(heavy.velocity.x, 8882056, 1);
    EXPECT_EQ(light.velocity.y, 0);
}

TEST(Bounce, TurnsAGlancingBodyAlongTheLineBetweenTheCentres) {
    Body a = body(16, 100, 50, 1, 0), b = body(16, 106, 56, 0, 0);
    bounce(a, b);  // 45 degrees: each takes half
    EXPECT_NEAR(a.velocity.x, PIXEL_PER_TICK / 2, 1);
    EXPECT_NEAR(a.velocity.y, -PIXEL_PER_TICK / 2, 1);
    EXPECT_NEAR(b.velocity.x, PIXEL_PER_TICK / 2, 1);
    EXPECT_NEAR(b.velocity.y, PIXEL_PER_TICK / 2, 1);
}

TEST(Bounce, LeavesTheVelocitiesOfPartingBodiesAlone) {
    Body a = body(16, 100, 50, -1, 0), b = body(12, 110, 50, 0.5, 1);
    const Vec2 before_a = a.velocity, before_b = b.velocity;
    bounce(a, b);
    EXPECT_EQ(a.velocity, before_a);
    EXPECT_EQ(b.velocity, before_b);
}

TEST(Bounce, KeepsEnergyAndMomentumWhateverTheAngle) {
    std::mt19937 random{1};
    std::uniform_real_distribution<double> place{-14, 14}, velocity{-1.5, 1.5};
    std::uniform_int_distribution<unsigned> size{MIN_SIZE, MAX_SIZE};
    for (int i = 0; i < 10000; ++i) {
        Body a = body(size(random), 100, 100, velocity(random), velocity(random));
        Body b = body(size(random), 100 + place(random), 100 + place(random), velocity(random),
                      velocity(random));
        const Body a0 = a, b0 = b;
        bounce(a, b);
        ASSERT_NEAR((energy(a) + energy(b)) / (energy(a0) + energy(b0)), 1, 1e-6) << i;
        const double momentum = double(mass(a)) * (a.velocity.x - a0.velocity.x) +
                                double(mass(b)) * (b.velocity.x - b0.velocity.x);
        ASSERT_NEAR(momentum, 0, double(mass(a) + mass(b))) << i;
    }
}

TEST(Bounce, PushesBodiesApartEvenFromOnePlace) {
    Body a = body(16, 100, 50, 0, 0), b = a;
    bounce(a, b);
    EXPECT_EQ(b.position.x - a.position.x, 2 * PUSH);
    Body above = body(16, 100, 50, 0, 0), below = body(16, 100, 53, 0, 0);
    bounce(above, below);
    EXPECT_EQ(above.position, (Vec2{100 * PIXEL, 50 * PIXEL - PUSH}));
    EXPECT_EQ(below.position, (Vec2{100 * PIXEL, 53 * PIXEL + PUSH}));
}

TEST(Bounce, NeverExceedsTheGreatestVelocity) {
    Body light = body(12, 100, 50, 8, 8), heavy = body(20, 140, 90, -8, -8);
    for (int i = 0; i < 3; ++i) {
        bounce(light, heavy);
        for (const std::int32_t v : {light.velocity.x, light.velocity.y, heavy.velocity.x})
            EXPECT_LE(std::abs(v), MAX_VELOCITY);
        heavy.velocity = {-MAX_VELOCITY, -MAX_VELOCITY};
    }
    EXPECT_EQ(light.velocity, (Vec2{-MAX_VELOCITY, -MAX_VELOCITY}));
}

TEST(BounceOff, SendsABodyInwardFromEachEdge) {
    const struct {
        Edge edge;
        Vec2 velocity, pushed;
    } cases[] = {{LEFT, {3, -5}, {PUSH, 0}},
                 {RIGHT, {-3, -5}, {-PUSH, 0}},
                 {TOP, {-3, 5}, {0, PUSH}},
                 {BOTTOM, {-3, -5}, {0, -PUSH}}};
    for (const auto& c : cases) {
        Body b = body(16, 0, 0, 0, 0);
        b.velocity = {-3, -5};
        bounce_off(c.edge, b);
        EXPECT_EQ(b.velocity, c.velocity) << c.edge;
        EXPECT_EQ(b.position, c.pushed) << c.edge;
        bounce_off(c.edge, b);
        EXPECT_EQ(b.velocity, c.velocity) << c.edge << ", already on its way in";
    }
}

TEST(Sine, IsRoundedRightAtEveryStep) {
    for (int step = 0; step < 1024; ++step) {
        const Angle angle = static_cast<Angle>(step) << 22;
        EXPECT_EQ(sine(angle), std::lround(SINE_ONE * std::sin(step * M_PI / 512))) << step;
        EXPECT_EQ(cosine(angle), std::lround(SINE_ONE * std::cos(step * M_PI / 512))) << step;
    }
}

TEST(Random, GivesEachSeedItsOwnNumbersAndTheSameAgain) {
    std::set<std::uint32_t> firsts;
    for (std::uint32_t seed = 0; seed < 1000; ++seed) {
        Random one{seed}, two{seed};
        for (int i = 0; i < 10; ++i) EXPECT_EQ(one.next(), two.next());
        firsts.insert(one.next());
    }
    EXPECT_EQ(firsts.size(), 1000u);
}

TEST(Random, SpreadsEvenlyBetweenItsBoundsBothIncluded) {
    Random random{9};
    int seen[9] = {};
    for (int i = 0; i < 90000; ++i) {
        const std::int32_t number = random.between(-4, 4);
        ASSERT_TRUE(number >= -4 && number <= 4);
        ++seen[number + 4];
    }
    for (const int count : seen) EXPECT_NEAR(count, 10000, 500);  // five standard deviations
    EXPECT_EQ(random.between(7, 7), 7);
}

}  // namespace
