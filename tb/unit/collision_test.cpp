// collision_test.cpp - the line test and both algorithms against brute force of another making.
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <cstdlib>
#include <numeric>
#include <vector>

#include "collision/crossing.h"
#include "collision/detect.h"

namespace {

using namespace collision;

using Wide = __int128;

// The same worlds on every run; set RC_PARAMS to look for others.
const bool SEEDED = setenv("RC_PARAMS", "seed=1 max_success=300", 0) == 0;

// ---- Brute force: parameters along both lines as exact fractions, no boxes, no sides ----

Wide cross_product(Vec2 a, Vec2 b) { return Wide{a.x} * b.y - Wide{a.y} * b.x; }
Wide dot_product(Vec2 a, Vec2 b) { return Wide{a.x} * b.x + Wide{a.y} * b.y; }
Vec2 minus(Vec2 a, Vec2 b) { return {a.x - b.x, a.y - b.y}; }

bool within(Wide numerator, Wide denominator) {
    if (denominator < 0) numerator = -numerator, denominator = -denominator;
    return numerator >= 0 && numerator <= denominator;
}

bool on_line(Vec2 point, const Line& line) {
    const Vec2 along = minus(line.b, line.a), to = minus(point, line.a);
    return cross_product(along, to) == 0 && dot_product(to, along) >= 0 &&
           dot_product(to, along) <= dot_product(along, along) && (along != Vec2{} || to == Vec2{});
}

bool meet(const Line& p, const Line& q) {
    const Vec2 r = minus(p.b, p.a), s = minus(q.b, q.a), between = minus(q.a, p.a);
    const Wide turn = cross_product(r, s);
    if (turn == 0)  // parallel, or a point: then an end of one lies on the other
        return on_line(p.a, q) || on_line(p.b, q) || on_line(q.a, p) || on_line(q.b, p);
    return within(cross_product(between, s), turn) && within(cross_product(between, r), turn);
}

Pairs brute_force(const std::vector<Polygon>& shapes) {
    Pairs pairs;
    for (unsigned i = 0; i < shapes.size(); ++i)
        for (unsigned j = i + 1; j < shapes.size(); ++j)
            for (unsigned k = 0; k < shapes[i].count; ++k)
                for (unsigned l = 0; l < shapes[j].count; ++l)
                    if (meet(shapes[i].lines[k], shapes[j].lines[l])) pairs.insert({i, j});
    return pairs;
}

// ---- Worlds ----

Polygon polygon(const std::vector<Vec2>& corners) {
    Polygon made;
    EXPECT_TRUE(made.outline(corners.data(), static_cast<unsigned>(corners.size())));
    return made;
}

Polygon square(std::int32_t x, std::int32_t y, std::int32_t side) {
    return polygon({{x, y}, {x + side, y}, {x + side, y + side}, {x, y + side}});
}

Polygon x_shape(std::int32_t x, std::int32_t y) {
    return polygon({{x + 1, y},
                    {x + 3, y + 2},
                    {x + 2, y + 3},
                    {x, y + 1},
                    {x - 2, y + 3},
                    {x - 3, y + 2},
                    {x - 1, y},
                    {x - 3, y - 2},
                    {x - 2, y - 3},
                    {x, y - 1},
                    {x + 2, y - 3},
                    {x + 3, y - 2}});
}

rc::Gen<Vec2> points(std::int32_t reach) {
    return rc::gen::map(
        rc::gen::pair(rc::gen::inRange(-reach, reach + 1), rc::gen::inRange(-reach, reach + 1)),
        [](std::pair<int, int> at) {
            return Vec2{at.first, at.second};
        });
}

// Points (one corner), lines there and back (two), and outlines of up to `most` corners.
std::vector<Polygon> any_world(std::int32_t reach, unsigned most) {
    const auto size = *rc::gen::inRange(0, 61);
    std::vector<Polygon> shapes;
    for (int i = 0; i < size; ++i) {
        if (!shapes.empty() && *rc::gen::inRange(0, 8) == 0) {
            shapes.push_back(shapes[*rc::gen::inRange<std::size_t>(0, shapes.size())]);
            continue;
        }
        const auto corners = *rc::gen::inRange(1u, most + 1);
        shapes.push_back(polygon(*rc::gen::container<std::vector<Vec2>>(corners, points(reach))));
    }
    return shapes;
}

void expect_all_agree(const std::vector<Polygon>& shapes) {
    const Pairs truth = brute_force(shapes);
    for (const Algorithm algorithm : ALGORITHMS) RC_ASSERT(detect(algorithm, shapes) == truth);
}

// ---- Lines ----

struct LineCase {
    const char* what;
    Line p, q;
    bool meet;
};

TEST(Crossing, KnowsTheCasesWorkedOutByHand) {
    constexpr std::int32_t FAR = COORDINATE_LIMIT - 1;
    constexpr Vec2 FIBONACCI_44 = {701408733, 433494437}, FIBONACCI_43 = {433494437, 267914296};
    const LineCase cases[] = {
        {"a plain cross", {{-1, 0}, {1, 0}}, {{0, -1}, {0, 1}}, true},
        {"a T", {{-1, 0}, {1, 0}}, {{0, 0}, {0, 5}}, true},
        {"an end on an end", {{0, 0}, {2, 1}}, {{2, 1}, {3, 9}}, true},
        {"short of a T", {{-4, 0}, {4, 0}}, {{0, 1}, {0, 5}}, false},
        {"parallel", {{0, 0}, {4, 4}}, {{1, 0}, {5, 4}}, false},
        {"collinear with a gap", {{0, 0}, {2, 2}}, {{3, 3}, {5, 5}}, false},
        {"collinear, touching", {{0, 0}, {2, 2}}, {{2, 2}, {5, 5}}, true},
        {"collinear, one within", {{0, 0}, {9, 9}}, {{5, 5}, {3, 3}}, true},
        {"a point on a line", {{0, 0}, {4, 2}}, {{2, 1}, {2, 1}}, true},
        {"a point beside a line", {{0, 0}, {4, 2}}, {{2, 2}, {2, 2}}, false},
        {"a point on the line's extension", {{0, 0}, {4, 2}}, {{6, 3}, {6, 3}}, false},
        {"a point on itself", {{7, 7}, {7, 7}}, {{7, 7}, {7, 7}}, true},
        {"two points", {{7, 7}, {7, 7}}, {{7, 8}, {7, 8}}, false},
        {"boxes overlap, lines do not", {{0, 0}, {9, 9}}, {{1, 0}, {9, 8}}, false},
        {"the whole grid", {{-FAR, -FAR}, {FAR, FAR}}, {{-FAR, FAR}, {FAR, -FAR}}, true},
        {"a product of 2^58 less by one: below",
         {{0, 0}, FIBONACCI_44},
         {FIBONACCI_43, {433494437, 0}},
         false},
        {"a product of 2^58 less by one: across",
         {{0, 0}, FIBONACCI_44},
         {FIBONACCI_43, {433494437, 267914297}},
         true},
        {"one unit off at the far end",
         {{-FAR, -FAR}, {FAR, FAR}},
         {{FAR, FAR - 1}, {0, -1}},
         false},
    };
    for (const LineCase& c : cases) {
        EXPECT_EQ(cross(c.p, c.q), c.meet) << c.what;
        EXPECT_EQ(cross(c.q, c.p), c.meet) << c.what << ", exchanged";
        EXPECT_EQ(cross(Line{c.p.b, c.p.a}, c.q), c.meet) << c.what << ", turned round";
    }
}

TEST(Crossing, AgreesWithFractionsOnASmallGridWhereNearlyEverythingTies) {
    std::vector<Line> lines;
    for (std::int32_t i = 0; i < 4 * 4 * 4 * 4; ++i)
        lines.push_back({{i & 3, i >> 2 & 3}, {i >> 4 & 3, i >> 6 & 3}});
    for (const Line& p : lines)
        for (const Line& q : lines) ASSERT_EQ(cross(p, q), meet(p, q));
}

TEST(Crossing, IsExactForNearMissesAllOverTheGrid) {
    const bool passed = rc::check([] {
        const auto anywhere = points(COORDINATE_LIMIT / 2);
        const Line p = {*anywhere, *anywhere};
        const auto part = *rc::gen::inRange<std::int64_t>(0, 1001);
        const Vec2 off = *points(2);  // q ends a hair from a point of p
        const Vec2 along = minus(p.b, p.a);
        const Vec2 end = {p.a.x + static_cast<std::int32_t>(along.x * part / 1000) + off.x,
                          p.a.y + static_cast<std::int32_t>(along.y * part / 1000) + off.y};
        const Line q = {*anywhere, end};
        RC_ASSERT(cross(p, q) == meet(p, q));
    });
    EXPECT_TRUE(passed);
}

// ---- Polygons ----

TEST(Polygon, MeasuresItsBoxAnewOnUpdate) {
    Polygon shape = polygon({{3, -2}, {7, 5}, {-1, 4}});
    EXPECT_EQ(shape.aabb.min, (Vec2{-1, -2}));
    EXPECT_EQ(shape.aabb.max, (Vec2{7, 5}));
    shape.lines[1].b = {-9, 40};
    shape.update();
    EXPECT_EQ(shape.aabb.min, (Vec2{-9, -2}));
    EXPECT_EQ(shape.aabb.max, (Vec2{7, 40}));
}

TEST(Polygon, IsUnchangedByAnOutlineOfTooManyCorners) {
    Polygon shape = square(0, 0, 4);
    const std::vector<Vec2> corners(Polygon::MAX_LINES + 1, Vec2{9, 9});
    EXPECT_FALSE(shape.outline(corners.data(), Polygon::MAX_LINES + 1));
    EXPECT_EQ(shape.count, 4u);
    EXPECT_EQ(shape.aabb.max, (Vec2{4, 4}));
}

// ---- Algorithms ----

struct WorldCase {
    const char* what;
    std::vector<Polygon> shapes;
    Pairs pairs;
};

TEST(Detect, KnowsTheCasesWorkedOutByHand) {
    const Polygon nothing;
    const WorldCase cases[] = {
        {"no shapes", {}, {}},
        {"one shape does not collide with itself", {square(0, 0, 4)}, {}},
        {"corners that touch", {square(0, 0, 4), square(4, 4, 4)}, {{0, 1}}},
        {"sides that touch", {square(0, 0, 4), square(4, 1, 4)}, {{0, 1}}},
        {"one unit apart", {square(0, 0, 4), square(5, 0, 4)}, {}},
        {"one inside the other", {square(0, 0, 9), square(3, 3, 2)}, {}},
        {"one inside, touching a side", {square(0, 0, 9), square(3, 3, 6)}, {{0, 1}}},
        {"the same twice", {square(0, 0, 4), square(0, 0, 4)}, {{0, 1}}},
        {"three on one place",
         {square(0, 0, 4), square(0, 0, 4), square(0, 0, 4)},
         {{0, 1}, {0, 2}, {1, 2}}},
        {"X into X", {x_shape(0, 0), x_shape(4, 0)}, {{0, 1}}},
        {"in the notch of an X, touching nothing", {x_shape(0, 0), square(0, 2, 0)}, {}},
        {"in the notch of an X, touching its side", {x_shape(0, 0), square(0, 2, 1)}, {{0, 1}}},
        {"L around L, boxes overlapping",
         {polygon({{0, 0}, {9, 0}, {9, 1}, {1, 1}, {1, 9}, {0, 9}}), square(2, 2, 9)},
         {}},
        {"a chain: a-b and b-c, not a-c",
         {square(0, 0, 4), square(6, 0, 4), square(3, 1, 4)},
         {{0, 2}, {1, 2}}},
        {"on one axis only", {square(0, 0, 4), square(2, 9, 4), square(9, 2, 4)}, {}},
        {"a polygon of no lines", {nothing, square(-2, 0, 4), nothing}, {}},
    };
    for (const WorldCase& c : cases)
        for (const Algorithm algorithm : ALGORITHMS)
            EXPECT_EQ(detect(algorithm, c.shapes), c.pairs) << c.what << ", " << name(algorithm);
}

TEST(Detect, FindsWhatBruteForceFindsInSparseWorlds) {
    EXPECT_TRUE(rc::check([] { expect_all_agree(any_world(COORDINATE_LIMIT - 1, 4)); }));
}

TEST(Detect, FindsWhatBruteForceFindsWherePositionsTie) {
    EXPECT_TRUE(rc::check([] { expect_all_agree(any_world(6, 5)); }));
}

TEST(Detect, FindsWhatBruteForceFindsAmongPointsAndLines) {
    EXPECT_TRUE(rc::check([] { expect_all_agree(any_world(5, 2)); }));
}

TEST(Detect, FindsWhatBruteForceFindsWhereShapesAreSmallInTheirWorld) {
    EXPECT_TRUE(rc::check([] {
        const auto corner = points(30);
        const auto sides = rc::gen::inRange(0, 12);
        std::vector<Polygon> shapes;
        const auto size = *rc::gen::inRange(0, 61);
        for (int i = 0; i < size; ++i) {
            const Vec2 at = *corner;
            shapes.push_back(i % 3 ? square(at.x, at.y, *sides) : x_shape(at.x, at.y));
        }
        expect_all_agree(shapes);
    }));
}

TEST(Detect, DoesNotDependOnTheOrderOfTheShapes) {
    EXPECT_TRUE(rc::check([] {
        const std::vector<Polygon> shapes = any_world(8, 4);
        std::vector<std::uint32_t> from(shapes.size());
        std::iota(from.begin(), from.end(), 0u);
        for (std::size_t i = from.size(); i > 1; --i)
            std::swap(from[i - 1], from[*rc::gen::inRange<std::size_t>(0, i)]);
        std::vector<Polygon> shuffled;
        for (const std::uint32_t i : from) shuffled.push_back(shapes[i]);
        for (const Algorithm algorithm : ALGORITHMS) {
            Pairs back;
            for (const auto& [first, second] : detect(algorithm, shuffled))
                back.insert(pair_of(from[first], from[second]));
            RC_ASSERT(back == detect(algorithm, shapes));
        }
    }));
}

TEST(Detect, SeesTheSameInAMirror) {
    EXPECT_TRUE(rc::check([] {
        const std::vector<Polygon> shapes = any_world(8, 4);
        std::vector<Polygon> left_right = shapes, axes_exchanged = shapes;
        const auto each_point = [](std::vector<Polygon>& all, auto change) {
            for (Polygon& shape : all) {
                for (Line& line : shape.lines) change(line.a), change(line.b);
                shape.update();
            }
        };
        each_point(left_right, [](Vec2& point) { point.x = -point.x; });
        each_point(axes_exchanged, [](Vec2& point) { std::swap(point.x, point.y); });
        for (const Algorithm algorithm : ALGORITHMS) {
            const Pairs pairs = detect(algorithm, shapes);
            RC_ASSERT(detect(algorithm, left_right) == pairs);
            RC_ASSERT(detect(algorithm, axes_exchanged) == pairs);
        }
    }));
}

TEST(Detect, NamesTheAlgorithmsAndGoesRoundThem) {
    EXPECT_STREQ(name(Algorithm::ORIGINAL), "original");
    EXPECT_STREQ(name(Algorithm::IMPROVED), "improved");
    Algorithm algorithm = ALGORITHMS.front();
    for (std::size_t i = 0; i < ALGORITHMS.size(); ++i) {
        EXPECT_EQ(algorithm, ALGORITHMS[i]);
        algorithm = next(algorithm);
    }
    EXPECT_EQ(algorithm, ALGORITHMS.front());
}

TEST(CollisionPair, IsOrderedLikeWordsInADictionary) {
    EXPECT_LT((CollisionPair{1, 9}), (CollisionPair{2, 3}));
    EXPECT_LT((CollisionPair{1, 3}), (CollisionPair{1, 9}));
    EXPECT_FALSE((CollisionPair{1, 3} < CollisionPair{1, 3}));
    EXPECT_EQ(pair_of(7, 2), (CollisionPair{2, 7}));
}

}  // namespace
