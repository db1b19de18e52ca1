// crossing_test.cpp - the line test, by hand and against fractions.
#include "collision/crossing.h"

#include <cstdint>
#include <vector>

#include "tb/unit/collision/truth.h"
#include "tb/unit/collision/worlds.h"

namespace {

using namespace worlds;

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

TEST(Crossing, AgreesWithFractionsOnASmallGrid) {
    std::vector<Line> lines;
    for (std::int32_t i = 0; i < 4 * 4 * 4 * 4; ++i)
        lines.push_back({{i & 3, i >> 2 & 3}, {i >> 4 & 3, i >> 6 & 3}});
    for (const Line& p : lines)
        for (const Line& q : lines) ASSERT_EQ(cross(p, q), truth::meet(p, q));
}

TEST(Crossing, IsExactForNearMissesAllOverTheGrid) {
    const bool passed = rc::check([] {
        const auto anywhere = [] { return point({0, 0}, COORDINATE_LIMIT - 1); };
        const Line p = {anywhere(), anywhere()};
        const std::int64_t part = between(0, 1000);
        const auto there = [part](std::int64_t a, std::int64_t b) {
            return static_cast<std::int32_t>(a + (b - a) * part / 1000);
        };
        // q ends very close to a point of p.
        const Vec2 end = point({there(p.a.x, p.b.x), there(p.a.y, p.b.y)}, 2);
        const Line q = {anywhere(), end};
        RC_ASSERT(cross(p, q) == truth::meet(p, q));
    });
    EXPECT_TRUE(passed);
}

TEST(Crossing, IsDefinedForCoordinatesBeyondTheGrid) {
    constexpr std::int32_t LEAST = INT32_MIN, MOST = INT32_MAX;
    const Line p = {{LEAST, LEAST}, {MOST, MOST}}, q = {{LEAST, MOST}, {MOST, LEAST}};
    EXPECT_EQ(cross(p, q), cross(p, q));  // for the sanitizer to see
}

}  // namespace
