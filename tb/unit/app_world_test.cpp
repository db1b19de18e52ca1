// app_world_test.cpp - the keys, new shapes and the step.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <tuple>

#include "app/world.h"

namespace {

using namespace app;
using collision::Algorithm;
using collision::PIXEL;
using collision::Vec2;

auto state(const Body& b) {
    return std::tuple{b.position.x, b.position.y, b.velocity.x, b.velocity.y, b.angle,
                      b.spin,       b.shape,      b.size,       b.colour};
}

testing::AssertionResult same(const World& a, const World& b) {
    Random random_a = a.random, random_b = b.random;
    if (a.count != b.count || a.pairs != b.pairs || a.pairs_before != b.pairs_before ||
        a.algorithm != b.algorithm || a.paused != b.paused || a.show_boxes != b.show_boxes ||
        a.speed_level != b.speed_level || a.last_shape != b.last_shape || a.tick != b.tick ||
        random_a.next() != random_b.next())
        return testing::AssertionFailure() << "at tick " << a.tick;
    for (unsigned i = 0; i < a.count; ++i)
        if (state(a.bodies[i]) != state(b.bodies[i]))
            return testing::AssertionFailure() << "body " << i << " at tick " << a.tick;
    return testing::AssertionSuccess();
}

World world_after(std::string_view keys, std::uint32_t seed = 1) {
    World world{seed};
    step(world, {keys});
    return world;
}

// ---- Keys ----

TEST(Keys, OneToSixInsertTheirShape) {
    const World world = world_after("123456");
    ASSERT_EQ(world.count, 6u);
    const Shape shapes[] = {Shape::SQUARE,   Shape::X,     Shape::TRIANGLE,
                            Shape::PENTAGON, Shape::ARROW, Shape::STAR};
    const unsigned lines[] = {4, 12, 3, 5, 4, 10};
    for (unsigned i = 0; i < 6; ++i) {
        EXPECT_EQ(world.bodies[i].shape, shapes[i]);
        EXPECT_EQ(world.polygons[EDGES + i].count, lines[i]);
    }
}

TEST(Keys, ZeroInsertsTenOfTheLastShape) {
    World world = world_after("0");
    EXPECT_EQ(world.count, 10u);
    EXPECT_EQ(world.bodies[9].shape, Shape::SQUARE);
    step(world, {"30"});
    EXPECT_EQ(world.count, 21u);
    for (unsigned i = 10; i < 21; ++i) EXPECT_EQ(world.bodies[i].shape, Shape::TRIANGLE);
}

TEST(Keys, ShapesBeyondTheCapacityAreIgnored) {
    World world = world_after(std::string(25, '0') + "666666");
    ASSERT_EQ(world.count, 256u);
    World further = world;
    step(world, {""});
    step(further, {"1"});
    EXPECT_EQ(further.last_shape, Shape::SQUARE);
    further.last_shape = world.last_shape;
    EXPECT_TRUE(same(world, further));
}

TEST(Keys, AGoesThroughAllAlgorithms) {
    World world{1};
    std::set<Algorithm> seen;
    for (std::size_t i = 0; i < collision::ALGORITHMS.size(); ++i) {
        seen.insert(world.algorithm);
        step(world, {"A"});
    }
    EXPECT_EQ(seen.size(), collision::ALGORITHMS.size());
    EXPECT_EQ(world.algorithm, World{1}.algorithm);
}

TEST(Keys, BHoldsTheShapesStillUntilPressedAgain) {
    World world = world_after("00B");
    const World before = world;
    for (int i = 0; i < 20; ++i) step(world, {""});
    for (unsigned i = 0; i < world.count; ++i)
        EXPECT_EQ(state(world.bodies[i]), state(before.bodies[i]));
    step(world, {"B"});
    for (unsigned i = 0; i < world.count; ++i)
        EXPECT_NE(state(world.bodies[i]), state(before.bodies[i]));
}

TEST(Keys, AShapeInsertedInAPauseHasItsPolygon) {
    World world = world_after("B");
    step(world, {"2"});
    EXPECT_EQ(world.polygons[EDGES].count, 12u);
}

TEST(Keys, CTakesAllShapesAway) {
    World world = world_after("00000000");
    ASSERT_FALSE(world.pairs.empty());
    step(world, {"C"});
    EXPECT_EQ(world.count, 0u);
    EXPECT_TRUE(world.pairs.empty());
    EXPECT_TRUE(world.pairs_before.empty());
    step(world, {"5"});
    EXPECT_EQ(world.count, 1u);
}

TEST(Keys, DShowsTheBoxesAndHidesThem) {
    World world = world_after("D");
    EXPECT_TRUE(world.show_boxes);
    step(world, {"D"});
    EXPECT_FALSE(world.show_boxes);
}

TEST(Keys, FDoublesTheSpeedAndEHalvesItWithinBounds) {
    World start{3};
    step(start, {"1"});
    start.bodies[0] = {};
    start.bodies[0].position = {160 * PIXEL, 120 * PIXEL};
    start.bodies[0].velocity = {PIXEL_PER_TICK, -PIXEL_PER_TICK / 2};
    start.bodies[0].spin = 1 << 20;
    const auto moved = [&start](std::string_view keys) {
        World world = start;
        step(world, {keys});
        EXPECT_EQ(world.bodies[0].velocity, start.bodies[0].velocity);
        const Vec2 to = world.bodies[0].position, from = start.bodies[0].position;
        EXPECT_EQ(to.y - from.y, -(to.x - from.x) / 2);
        EXPECT_EQ(world.bodies[0].angle, (to.x - from.x) * std::int64_t{1 << 20} / PIXEL);
        return to.x - from.x;
    };
    EXPECT_EQ(moved(""), PIXEL);
    EXPECT_EQ(moved("F"), PIXEL * 2);
    EXPECT_EQ(moved("FF"), PIXEL * 4);
    EXPECT_EQ(moved("FFFFFF"), PIXEL * 4);
    EXPECT_EQ(moved("E"), PIXEL / 2);
    EXPECT_EQ(moved("EE"), PIXEL / 4);
    EXPECT_EQ(moved("EEEEEE"), PIXEL / 4);
    EXPECT_EQ(moved("FEEF"), PIXEL);
}

TEST(Keys, OthersAreIgnored) {
    World world = world_after("12"), pressed = world;
    step(world, {""});
    step(pressed, {std::string_view{"789abcdefxG \n\0\xff", 15}});
    EXPECT_TRUE(same(world, pressed));
}

// ---- New shapes ----

TEST(NewShape, LiesClearOfTheEdgesAndMoves) {
    for (std::uint32_t seed = 0; seed < 40; ++seed) {
        World world = world_after("B0203040506010", seed);
        for (const auto& [first, second] : world.pairs)
            EXPECT_GE(first, EDGES) << "seed " << seed << ", body " << second - EDGES;
        for (unsigned i = 0; i < world.count; ++i) {
            const Body& body = world.bodies[i];
            EXPECT_GE(body.size, 12u);
            EXPECT_LE(body.size, 20u);
            const double speed = std::hypot(body.velocity.x, body.velocity.y) / PIXEL_PER_TICK;
            EXPECT_GT(speed, 0.49);
            EXPECT_LT(speed, 1.51);
        }
    }
}

TEST(NewShape, IsDifferentEachTimeAndForEachSeed) {
    const World one = world_after("00", 1), two = world_after("00", 2);
    std::set<decltype(state(Body{}))> seen;
    for (unsigned i = 0; i < 20; ++i) {
        seen.insert(state(one.bodies[i]));
        seen.insert(state(two.bodies[i]));
    }
    EXPECT_EQ(seen.size(), 40u);
}

TEST(NewShape, TouchesTheCircleOfItsSizeAndNeverLeavesIt) {
    for (const Shape shape :
         {Shape::SQUARE, Shape::X, Shape::TRIANGLE, Shape::PENTAGON, Shape::ARROW, Shape::STAR}) {
        for (unsigned turn = 0; turn < 100; ++turn) {
            const auto outline = polygon(shape, {0, 0}, turn * 42949673u, 16);
            double longest = 0;
            for (unsigned i = 0; i < outline.count; ++i)
                longest = std::max(longest, std::hypot(outline.lines[i].a.x, outline.lines[i].a.y));
            EXPECT_NEAR(longest / PIXEL, 8, 0.01);
            EXPECT_LE(longest, 8 * PIXEL + 8) << "more than the sine's rounding";
        }
    }
}

// ---- Steps ----

TEST(Step, IsDeterministic) {
    World a{42}, b{42};
    const char* const script[] = {"1", "20",  "",  "A", "F0", "B",  "3",
                                  "B", "456", "E", "",  "D",  "0C0"};
    for (int i = 0; i < 1000; ++i) {
        step(a, {script[i % std::size(script)]});
        if (i == 500) b = World{a};  // a copy goes on as the original would
        if (i != 500) step(b, {script[i % std::size(script)]});
        ASSERT_TRUE(same(a, b));
    }
}

TEST(Step, IsItsThreePartsInOrder) {
    World whole{6}, parts{6};
    for (int i = 0; i < 200; ++i) {
        const Input input{i % 50 ? "" : "0"};
        step(whole, input);
        advance(parts, input);
        find_pairs(parts);
        respond(parts);
        ASSERT_TRUE(same(whole, parts));
    }
}

TEST(Step, KeepsThePairsOfTheTickBefore) {
    World world = world_after("0000000");
    for (int i = 0; i < 20; ++i) {
        const auto pairs = world.pairs;
        step(world, {""});
        EXPECT_EQ(world.pairs_before, pairs);
    }
}

TEST(Step, FindsNothingAmongTheEdgesOfAnEmptyScreen) {
    World world{1};
    for (const Algorithm algorithm : collision::ALGORITHMS) {
        world.algorithm = algorithm;
        step(world, {""});
        EXPECT_TRUE(world.pairs.empty());
    }
}

}  // namespace
