// worlds.h - polygons and worlds of them to try the library on.
#pragma once

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <cstdlib>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

#include "collision/detector.h"

namespace collision {

inline void PrintTo(CollisionPair pair, std::ostream* out) {
    *out << pair.first << "-" << pair.second;
}
inline void PrintTo(Vec2 point, std::ostream* out) { *out << point.x << "," << point.y; }

}  // namespace collision

namespace worlds {

using namespace collision;
using Shapes = std::vector<Polygon>;

// The same worlds on every run; set RC_PARAMS to look for others.
inline const bool SEEDED = setenv("RC_PARAMS", "seed=1 max_success=200", 0) == 0;

inline Polygon polygon(const std::vector<Vec2>& corners) {
    Polygon made;
    EXPECT_EQ(made.outline(corners.data(), static_cast<unsigned>(corners.size())), Error::NONE);
    return made;
}

inline Polygon square(std::int32_t x, std::int32_t y, std::int32_t side) {
    return polygon({{x, y}, {x + side, y}, {x + side, y + side}, {x, y + side}});
}

inline Polygon x_shape(std::int32_t x, std::int32_t y) {
    constexpr Vec2 CORNERS[] = {{1, 0},  {3, 2},   {2, 3},   {0, 1},  {-2, 3}, {-3, 2},
                                {-1, 0}, {-3, -2}, {-2, -3}, {0, -1}, {2, -3}, {3, -2}};
    std::vector<Vec2> corners;
    for (const Vec2 corner : CORNERS) corners.push_back({x + corner.x, y + corner.y});
    return polygon(corners);
}

// The result of a fresh detector, checked against that of one that counts.
inline PairList found(Algorithm algorithm, const Shapes& shapes) {
    PairList pairs{{7, 9}};
    Detector detector;
    EXPECT_EQ(detector.find(algorithm, shapes, pairs), Error::NONE);
    PairList counted;  // by standard C++ alone, where a Detector may use vectors
    CountingDetector counting;
    EXPECT_EQ(counting.find(algorithm, shapes, counted), Error::NONE);
    EXPECT_TRUE(counted == pairs);
    return pairs;
}

inline std::int32_t between(std::int32_t low, std::int32_t high) {
    return *rc::gen::resize(100, rc::gen::inRange(low, high + 1));
}

inline Vec2 point(Vec2 middle, std::int32_t reach) {
    const auto near = [reach](std::int32_t at) {
        const std::int64_t low = std::int64_t{at} - reach, high = std::int64_t{at} + reach;
        constexpr std::int64_t MOST = COORDINATE_LIMIT - 1;
        return between(static_cast<std::int32_t>(low < -MOST ? -MOST : low),
                       static_cast<std::int32_t>(high > MOST ? MOST : high));
    };
    return {near(middle.x), near(middle.y)};
}

// From 0 to `most` shapes: outlines of 1 (points), 2 (a line there and back) to `corners` corners
// within `size` about places within `reach`; now and then one of no lines, or an earlier one again.
inline Shapes any(std::int32_t reach, std::int32_t size, unsigned corners, unsigned most) {
    const auto count = *rc::gen::resize(100, rc::gen::inRange(0u, most + 1));
    Shapes shapes;
    for (unsigned i = 0; i < count; ++i) {
        const auto kind = between(0, 15);
        if (kind == 0) {
            shapes.emplace_back();
        } else if (kind <= 2 && i > 0) {
            shapes.push_back(shapes[static_cast<unsigned>(between(0, static_cast<int>(i) - 1))]);
        } else {
            const Vec2 middle = point({0, 0}, reach);
            std::vector<Vec2> outline(static_cast<unsigned>(between(1, static_cast<int>(corners))));
            for (Vec2& corner : outline) corner = point(middle, size);
            shapes.push_back(polygon(outline));
        }
    }
    return shapes;
}

struct Kind {
    const char* name;
    Shapes (*make)();
};

// Spread out, in clusters, at a few places, at one, in a row, as points, and over the whole grid.
inline const Kind KINDS[] = {
    {"random", [] { return any(100'000, 20'000, 5, 60); }},
    {"clustered",
     [] {
         Shapes shapes;
         for (int heap = 0; heap < 3; ++heap) {
             const Vec2 at = point({0, 0}, COORDINATE_LIMIT / 2);
             for (const Polygon& shape : any(50, 20, 5, 20)) {
                 shapes.push_back(shape);
                 for (Line& line : shapes.back().lines)
                     line = {{line.a.x + at.x, line.a.y + at.y},
                             {line.b.x + at.x, line.b.y + at.y}};
                 shapes.back().update();
             }
         }
         return shapes;
     }},
    {"tied", [] { return any(4, 3, 5, 60); }},
    {"stacked", [] { return any(0, 6, 6, 30); }},
    {"collinear",
     [] {
         Shapes shapes;
         const auto count = between(0, 60);
         for (int i = 0; i < count; ++i) {
             const std::int32_t from = between(-200, 200), to = from + between(0, 20);
             shapes.push_back(polygon({{2 * from, from}, {2 * to, to}}));
         }
         return shapes;
     }},
    {"upright and level",
     [] {
         Shapes shapes;
         const auto count = between(0, 60);
         for (int i = 0; i < count; ++i) {
             const Vec2 a = point({0, 0}, 12);
             const std::int32_t length = between(0, 12);
             shapes.push_back(
                 polygon({a, i % 2 ? Vec2{a.x + length, a.y} : Vec2{a.x, a.y + length}}));
         }
         return shapes;
     }},
    {"points", [] { return any(5, 0, 1, 60); }},
    {"touching",
     [] {
         Shapes shapes;
         const auto count = between(0, 60);
         for (int i = 0; i < count; ++i)
             shapes.push_back(square(8 * between(-4, 4), 8 * between(-4, 4), 8 * between(0, 2)));
         return shapes;
     }},
    {"huge", [] { return any(COORDINATE_LIMIT - 1, COORDINATE_LIMIT - 1, 16, 40); }},
    {"very different in size",
     [] {
         Shapes shapes;
         const auto count = between(0, 60);
         for (int i = 0; i < count; ++i) {
             const Vec2 at = point({0, 0}, 10'000'000);
             shapes.push_back(square(at.x, at.y, 1 << between(0, 28)));
         }
         return shapes;
     }},
    {"concave",
     [] {
         Shapes shapes;
         const auto count = between(0, 60);
         for (int i = 0; i < count; ++i) {
             const Vec2 at = point({0, 0}, 25);
             shapes.push_back(i % 3 ? square(at.x, at.y, between(0, 11)) : x_shape(at.x, at.y));
         }
         return shapes;
     }},
};

// For INSTANTIATE_TEST_SUITE_P.
inline std::string name_of(const testing::TestParamInfo<Kind>& kind) {
    std::string name = kind.param.name;
    std::replace(name.begin(), name.end(), ' ', '_');
    return name;
}

inline void PrintTo(const Kind& kind, std::ostream* out) { *out << kind.name; }

}  // namespace worlds
