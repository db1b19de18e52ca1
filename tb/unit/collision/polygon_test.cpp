// polygon_test.cpp - outlines, boxes, moving and turning, and conversion to the grid.
#include "collision/polygon.h"

#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "collision/fixed_box.h"
#include "collision/grid.h"
#include "collision/turn.h"
#include "tb/unit/collision/worlds.h"

namespace {

using namespace worlds;

bool contains(const Aabb& box, Vec2 point) {
    return box.min.x <= point.x && point.x <= box.max.x && box.min.y <= point.y &&
           point.y <= box.max.y;
}

bool contains(const Aabb& box, const Polygon& shape) {
    for (unsigned i = 0; i < shape.count; ++i)
        if (!contains(box, shape.lines[i].a) || !contains(box, shape.lines[i].b)) return false;
    return true;
}

bool closed(const Polygon& shape) {
    for (unsigned i = 0; i < shape.count; ++i)
        if (shape.lines[i].b != shape.lines[(i + 1) % shape.count].a) return false;
    return true;
}

Turn any_turn() {
    const double angle = between(0, 1'000'000) * 1e-6 * 2 * M_PI;
    return {static_cast<std::int32_t>(std::lround(std::cos(angle) * TURN_ONE)),
            static_cast<std::int32_t>(std::lround(std::sin(angle) * TURN_ONE))};
}

Polygon any_polygon(std::int32_t reach, std::int32_t size) {
    const Vec2 middle = point({0, 0}, reach);
    std::vector<Vec2> corners(static_cast<unsigned>(between(1, 16)));
    for (Vec2& corner : corners) corner = point(middle, size);
    return polygon(corners);
}

// ---- Outline and box ----

TEST(Polygon, MeasuresItsBoxAnewOnUpdate) {
    Polygon shape = polygon({{3, -2}, {7, 5}, {-1, 4}});
    EXPECT_EQ(shape.aabb.min, (Vec2{-1, -2}));
    EXPECT_EQ(shape.aabb.max, (Vec2{7, 5}));
    shape.lines[1].b = {-9, 40};
    shape.update();
    EXPECT_EQ(shape.aabb.min, (Vec2{-9, -2}));
    EXPECT_EQ(shape.aabb.max, (Vec2{7, 40}));
}

TEST(Polygon, RefusesTooManyCornersAndStaysAsItIs) {
    Polygon shape = square(0, 0, 4);
    const std::vector<Vec2> corners(Polygon::MAX_LINES + 1, Vec2{9, 9});
    EXPECT_EQ(shape.outline(corners.data(), Polygon::MAX_LINES + 1), Error::TOO_MANY_LINES);
    EXPECT_EQ(shape.count, 4u);
    EXPECT_EQ(shape.aabb.max, (Vec2{4, 4}));
}

TEST(Polygon, RefusesACornerOutsideTheGrid) {
    Polygon shape = square(0, 0, 4);
    for (const std::int32_t far : {COORDINATE_LIMIT, -COORDINATE_LIMIT, INT32_MAX, INT32_MIN}) {
        const Vec2 corners[] = {{0, 0}, {9, far}};
        EXPECT_EQ(shape.outline(corners, 2), Error::OUTSIDE_GRID) << far;
        EXPECT_EQ(shape.aabb.max, (Vec2{4, 4}));
    }
}

TEST(Polygon, OfOneCornerIsAPoint) {
    const Polygon one = polygon({{3, 4}}), none = polygon({});
    EXPECT_EQ(one.count, 1u);
    EXPECT_EQ(one.lines[0].a, one.lines[0].b);
    EXPECT_EQ(none.count, 0u);
}

// ---- Moving and turning ----

TEST(Moved, KeepsLinesClosedAndTheirWays) {
    EXPECT_TRUE(rc::check([] {
        const Polygon shape = any_polygon(1000, 1000);
        const Vec2 by = point({0, 0}, 1'000'000);
        const Polygon there = moved(shape, by);
        RC_ASSERT(closed(there));
        RC_ASSERT(contains(there.aabb, there));
        for (unsigned i = 0; i < shape.count; ++i)
            RC_ASSERT(
                (there.lines[i].a == Vec2{shape.lines[i].a.x + by.x, shape.lines[i].a.y + by.y}));
    }));
}

TEST(Turned, KeepsLinesClosed) {
    EXPECT_TRUE(rc::check([] {
        const Polygon there = turned(any_polygon(1000, 50'000), point({0, 0}, 1000), any_turn());
        RC_ASSERT(closed(there));
        RC_ASSERT(contains(there.aabb, there));
    }));
}

TEST(Turned, ByAQuarterTakesXToYExactly) {
    const Polygon there = turned(polygon({{7, 2}, {3, 9}}), {1, 1}, {0, TURN_ONE});
    EXPECT_EQ(there.lines[0].a, (Vec2{0, 7}));
    EXPECT_EQ(there.lines[0].b, (Vec2{-7, 3}));
}

TEST(Turned, IsWithinAUnitOfTheTurnInFloatingPoint) {
    EXPECT_TRUE(rc::check([] {
        const Polygon shape = any_polygon(0, 20'000);
        const Turn turn = any_turn();
        const Polygon there = turned(shape, {0, 0}, turn);
        for (unsigned i = 0; i < shape.count; ++i) {
            const double x = shape.lines[i].a.x, y = shape.lines[i].a.y;
            const double cosine = turn.cosine / 65536.0, sine = turn.sine / 65536.0;
            RC_ASSERT(std::abs(there.lines[i].a.x - (x * cosine - y * sine)) <= 0.5);
            RC_ASSERT(std::abs(there.lines[i].a.y - (x * sine + y * cosine)) <= 0.5);
        }
    }));
}

// ---- Fixed boxes ----

TEST(FixedBox, ContainsTheShapeHoweverItIsTurned) {
    EXPECT_TRUE(rc::check([] {
        const std::int32_t reach = 1 << between(0, 28);
        const Polygon shape = any_polygon(0, reach);
        const Vec2 centre = point({0, 0}, reach / 8);
        Aabb box;
        RC_ASSERT(fixed_box(shape, centre, box) == Error::NONE);
        for (int i = 0; i < 20; ++i) RC_ASSERT(contains(box, turned(shape, centre, any_turn())));
    }));
}

TEST(FixedBox, IsNoLargerThanTheCircleNeeds) {
    Aabb box;
    ASSERT_EQ(fixed_box(polygon({{30'000, 40'000}, {0, 7}}), {0, 0}, box), Error::NONE);
    EXPECT_GE(box.max.x, 50'000);
    EXPECT_LE(box.max.x, 50'004);
    EXPECT_EQ(box.min.y, -box.max.x);
}

TEST(FixedBox, IsMovedByTheVelocity) {
    const Aabb box = moved(Aabb{{1, 2}, {3, 4}}, {10, -20});
    EXPECT_EQ(box.min, (Vec2{11, -18}));
    EXPECT_EQ(box.max, (Vec2{13, -16}));
}

TEST(FixedBox, IsRefusedWhereItWouldLeaveTheGrid) {
    Aabb box{{1, 2}, {3, 4}};
    constexpr std::int32_t FAR = COORDINATE_LIMIT - 1;
    EXPECT_EQ(fixed_box(square(FAR - 9, 0, 9), {FAR - 4, 4}, box), Error::OUTSIDE_GRID);
    EXPECT_EQ(fixed_box(square(0, -FAR, 9), {4, -FAR + 4}, box), Error::OUTSIDE_GRID);
    EXPECT_EQ(fixed_box(square(0, 0, 9), {COORDINATE_LIMIT, 0}, box), Error::OUTSIDE_GRID);
    Polygon wrong = square(0, 0, 9);
    wrong.lines[3].a.y = INT32_MIN;
    EXPECT_EQ(fixed_box(wrong, {4, 4}, box), Error::OUTSIDE_GRID);
    wrong.count = 17;
    EXPECT_EQ(fixed_box(wrong, {4, 4}, box), Error::TOO_MANY_LINES);
    EXPECT_EQ(box.min, (Vec2{1, 2}));
}

// ---- The way onto the grid ----

TEST(ToGrid, RoundsToTheNearestUnit) {
    Vec2 point;
    ASSERT_EQ(to_grid(1.5, -2.25, point), Error::NONE);
    EXPECT_EQ(point, (Vec2{98304, -147456}));
    ASSERT_EQ(to_grid(0.7 / PIXEL, -0.5 / PIXEL, point), Error::NONE);
    EXPECT_EQ(point, (Vec2{1, -1}));
    ASSERT_EQ(to_grid(-0.0, 1e-300, point), Error::NONE);
    EXPECT_EQ(point, (Vec2{0, 0}));
}

TEST(ToGrid, RefusesWhatIsNoNumber) {
    constexpr double NAN_ = std::numeric_limits<double>::quiet_NaN();
    constexpr double INF = std::numeric_limits<double>::infinity();
    Vec2 point{5, 6};
    for (const double wrong : {NAN_, -NAN_, INF, -INF}) {
        EXPECT_EQ(to_grid(wrong, 0, point), Error::NOT_FINITE);
        EXPECT_EQ(to_grid(0, wrong, point), Error::NOT_FINITE);
    }
    EXPECT_EQ(point, (Vec2{5, 6}));
}

TEST(ToGrid, RefusesWhatLiesOutside) {
    Vec2 point{5, 6};
    for (const double wrong : {16384.0, -16384.0, 32768.0, 1e9, 1e308, -1e308, 16383.999999}) {
        EXPECT_EQ(to_grid(wrong, 0, point), Error::OUTSIDE_GRID) << wrong;
        EXPECT_EQ(to_grid(0, wrong, point), Error::OUTSIDE_GRID) << wrong;
    }
    EXPECT_EQ(point, (Vec2{5, 6}));
    EXPECT_EQ(to_grid(16383.99999, -16383.99999, point), Error::NONE);
}

}  // namespace
