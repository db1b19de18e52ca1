// app_long_run_test.cpp - worlds left alone for a long time.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <string>

#include "app/world.h"

namespace {

using namespace app;
using collision::Algorithm;
using collision::PIXEL;

constexpr std::int32_t RIGHT_BORDER = 320 * PIXEL, BOTTOM_BORDER = 240 * PIXEL;

double energy(const World& world) {
    double sum = 0;
    for (unsigned i = 0; i < world.count; ++i) {
        const Body& b = world.bodies[i];
        sum += b.size * b.size * (std::pow(b.velocity.x, 2) + std::pow(b.velocity.y, 2));
    }
    return sum;
}

void expect_inside_the_screen(const World& world) {
    for (unsigned i = 0; i < world.count; ++i) {
        const auto [min, max] = world.polygons[EDGES + i].aabb;
        ASSERT_TRUE(min.x >= 0 && min.y >= 0 && max.x < RIGHT_BORDER && max.y < BOTTOM_BORDER)
            << "body " << i << " at tick " << world.tick;
    }
}

// 200 shapes cover most of the screen; they must stay in it and keep their energy.
void run_full_screen(std::string_view keys) {
    World world{11};
    world.algorithm = Algorithm::ORIGINAL;  // half the time of the other
    step(world, {keys});
    ASSERT_EQ(world.count, 200u);
    const World start = world;
    const double energy_at_start = energy(start);
    for (int tick = 0; tick < 12000; ++tick) {
        step(world, {""});
        ASSERT_NO_FATAL_FAILURE(expect_inside_the_screen(world));
        ASSERT_LE(energy(world), energy_at_start * 1.00001) << "tick " << tick;
    }
    EXPECT_GT(energy(world), energy_at_start * 0.99);
    for (unsigned edge = 0; edge < EDGES; ++edge) {
        EXPECT_EQ(world.polygons[edge].aabb.min, start.polygons[edge].aabb.min);
        EXPECT_EQ(world.polygons[edge].aabb.max, start.polygons[edge].aabb.max);
    }
}

TEST(LongRun, TwoHundredShapesStayOnTheScreenWithTheirEnergy) {
    run_full_screen("10002000300040005000600010111");
}

TEST(LongRun, TwoHundredShapesStaySaneAtTopSpeed) { run_full_screen("FF00000000000000000000"); }

// The longest that any pair stays in contact without a break.
unsigned longest_contact(World& world, int ticks) {
    unsigned longest = 0;
    std::map<collision::CollisionPair, unsigned> lasting;
    for (int tick = 0; tick < ticks; ++tick) {
        step(world, {""});
        for (auto it = lasting.begin(); it != lasting.end();)
            it = std::binary_search(world.pairs.begin(), world.pairs.end(), it->first)
                     ? std::next(it)
                     : lasting.erase(it);
        for (const auto pair : world.pairs) longest = std::max(longest, ++lasting[pair]);
    }
    return longest;
}

TEST(LongRun, TwoShapesNeverStickTogether) {
    for (char first = '1'; first <= '6'; ++first) {
        for (char second = '1'; second <= '6'; ++second) {
            for (std::uint32_t seed = 0; seed < 4; ++seed) {
                for (const char* const speed : {"EE", "", "FF"}) {
                    World world{seed};
                    step(world, {std::string{first, second} + speed});
                    EXPECT_LE(longest_contact(world, 1500), 60u)
                        << first << second << speed << ", seed " << seed;
                }
            }
        }
    }
}

TEST(LongRun, TwoShapesInOnePlaceWithOneVelocityComeApart) {
    for (char key = '1'; key <= '6'; ++key) {
        World world{1};
        step(world, {std::string(2, key)});
        world.bodies[0].position = {20 * PIXEL, 20 * PIXEL};
        world.bodies[0].size = MAX_SIZE;
        world.bodies[1] = world.bodies[0];
        EXPECT_LE(longest_contact(world, 500), 60u) << key;
    }
}

}  // namespace
