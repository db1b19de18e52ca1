// app_draw_test.cpp - which parts of a world are drawn, and where.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>

#include "app/draw.h"
#include "gfx/font.h"

namespace {

using namespace app;
using collision::PIXEL;
using gfx::Canvas;

class Draw : public testing::Test {
protected:
    World world{1};
    Canvas canvas;

    void put(Shape shape, int x, int y, gfx::Colour colour) {
        Body& body = world.bodies[world.count++];
        body.shape = shape;
        body.position = {x * PIXEL, y * PIXEL};
        body.size = 20;
        body.colour = colour;
    }

    void show(std::string_view keys = "", std::uint32_t tick_us = 0) {
        step(world, {keys});
        draw(world, {tick_us}, canvas);
    }

    // Colours within 12 pixels of (x, y), black left out.
    std::set<gfx::Colour> colours_around(int x, int y) const {
        std::set<gfx::Colour> seen;
        for (int row = y - 12; row <= y + 12; ++row)
            for (int column = x - 12; column <= x + 12; ++column)
                seen.insert(canvas.row(row)[column]);
        seen.erase(gfx::BLACK);
        return seen;
    }

    // The text appears at (x, y), stroke for stroke, in one colour on black.
    testing::AssertionResult reads(std::string_view words, int x, int y) const {
        Canvas expected;
        gfx::text(expected, x, y, words, gfx::WHITE);
        std::set<gfx::Colour> ink;
        for (int row = y; row < y + gfx::CELL_HEIGHT - 1; ++row) {
            for (int column = x; column < x + gfx::text_width(words); ++column) {
                const gfx::Colour seen = canvas.row(row)[column];
                if ((seen != gfx::BLACK) != (expected.row(row)[column] == gfx::WHITE))
                    return testing::AssertionFailure() << "differs at " << column << ", " << row;
                if (seen != gfx::BLACK) ink.insert(seen);
            }
        }
        if (ink.size() != 1) return testing::AssertionFailure() << ink.size() << " colours";
        return testing::AssertionSuccess();
    }
};

constexpr gfx::Colour RED = gfx::rgb(255, 0, 0), BLUE = gfx::rgb(0, 0, 255);

TEST_F(Draw, ShowsAShapeInItsColourThroughItsCorners) {
    put(Shape::SQUARE, 100, 100, RED);
    show();
    EXPECT_EQ(colours_around(100, 100), std::set{RED});
    for (unsigned i = 0; i < 4; ++i) {
        const collision::Vec2 corner = world.polygons[EDGES].lines[i].a;
        EXPECT_EQ(canvas.row(corner.y / PIXEL)[corner.x / PIXEL], RED);
    }
    EXPECT_EQ(canvas.row(100)[100], gfx::BLACK) << "an outline is not filled";
}

TEST_F(Draw, FlashesShapesThatCollideAndOnlyThose) {
    put(Shape::SQUARE, 100, 100, RED);
    put(Shape::SQUARE, 108, 108, BLUE);
    put(Shape::SQUARE, 200, 100, RED);
    show();
    EXPECT_EQ(colours_around(100, 100), std::set{gfx::WHITE});
    EXPECT_EQ(colours_around(200, 100), std::set{RED});
    world.bodies[1].position = {108 * PIXEL, 180 * PIXEL};
    show();
    EXPECT_EQ(colours_around(100, 100), std::set{RED});
    EXPECT_EQ(colours_around(108, 180), std::set{BLUE});
}

TEST_F(Draw, ShowsTheBoxOnlyWhenAsked) {
    put(Shape::STAR, 100, 100, RED);
    show();
    EXPECT_EQ(colours_around(100, 100).size(), 1u);
    show("D");
    EXPECT_EQ(colours_around(100, 100).size(), 2u);
    const auto [min, max] = world.polygons[EDGES].aabb;
    for (const int y : {min.y / PIXEL, max.y / PIXEL})
        for (const int x : {min.x / PIXEL, max.x / PIXEL})
            EXPECT_NE(canvas.row(y)[x], gfx::BLACK) << "a corner of the box";
    show("D");
    EXPECT_EQ(colours_around(100, 100).size(), 1u);
}

TEST_F(Draw, FramesTheScreen) {
    show();
    const gfx::Colour edge = canvas.row(120)[0];
    EXPECT_NE(edge, gfx::BLACK);
    for (int x = 0; x < 320; ++x) {
        EXPECT_EQ(canvas.row(0)[x], edge);
        EXPECT_EQ(canvas.row(239)[x], edge);
    }
    for (int y = 0; y < 240; ++y) {
        EXPECT_EQ(canvas.row(y)[0], edge);
        EXPECT_EQ(canvas.row(y)[319], edge);
    }
}

TEST_F(Draw, WritesCountAlgorithmAndMilliseconds) {
    world.algorithm = collision::Algorithm::IMPROVED;
    for (int i = 0; i < 100; ++i) put(Shape::X, 100, 100, RED);
    show("", 1234);
    EXPECT_TRUE(reads("100 shapes  improved  1.23 ms", 5, 5));
    world.algorithm = collision::Algorithm::ORIGINAL;
    show("C1", 16670);
    EXPECT_TRUE(reads("1 shape  original  16.67 ms", 5, 5));
    show("C", 9);
    EXPECT_TRUE(reads("0 shapes  original  0.00 ms", 5, 5));
    show("", 4294967295);
    EXPECT_TRUE(reads("0 shapes  original  4294967.29 ms", 5, 5));
}

TEST_F(Draw, HasRoomForTheNameOfEveryAlgorithm) {
    for (unsigned i = 0; i < World::CAPACITY; ++i) put(Shape::X, 100, 200, RED);
    for (const collision::Algorithm algorithm : collision::ALGORITHMS) {
        world.algorithm = algorithm;
        show("", 99'990'000);
        EXPECT_TRUE(reads("256 shapes  " + std::string{name(algorithm)} + "  99990.00 ms", 5, 5));
    }
}

TEST_F(Draw, KeepsTheTextReadableOverShapes) {
    for (int x = 12; x < 180; x += 3) put(Shape::X, x, 12, RED);
    show("", 2050);
    EXPECT_TRUE(reads("56 shapes  simd  2.05 ms", 5, 5));
}

TEST_F(Draw, MarksAPause) {
    show("B");
    EXPECT_TRUE(reads("PAUSED", 142, 115));
    show("B");
    EXPECT_TRUE(colours_around(160, 120).empty());
}

TEST_F(Draw, LeavesNothingOfTheLastPicture) {
    show("00000D");
    for (int i = 0; i < 50; ++i) show();
    Canvas fresh;
    draw(world, {0}, fresh);
    for (int y = 0; y < Canvas::HEIGHT; ++y)
        ASSERT_TRUE(std::equal(fresh.row(y), fresh.row(y) + Canvas::WIDTH, canvas.row(y))) << y;
}

}  // namespace
