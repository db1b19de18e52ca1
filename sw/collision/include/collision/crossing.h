// crossing.h - do two lines, or the lines of two polygons, have a point in common?
//
// Two closed segments meet if and only if their closed boxes overlap and neither has both ends
// strictly on one side of the other.  That one rule covers crossing, touching, collinear and
// zero-length segments.  Exact for all coordinates on the grid: a difference is below 2^31 in size,
// and the difference of two products of those is at most 2^63 - 2^34 + 8.
#pragma once

#include <algorithm>
#include <cstdint>

#include "collision/polygon.h"
#include "collision/tally.h"

namespace collision {

// Wraps where coordinates are outside the grid, so that no input is undefined behaviour.
inline std::int64_t minus(std::int32_t a, std::int32_t b) {
    return static_cast<std::int32_t>(static_cast<std::uint32_t>(a) - static_cast<std::uint32_t>(b));
}

// Above 0: c lies to the left of the line from a to b (y up), below 0: to the right, 0: on it.
// Twice the area of the triangle a, b, c.
inline std::int64_t side(Vec2 a, Vec2 b, Vec2 c) {
    const std::int64_t left = minus(b.x, a.x) * minus(c.y, a.y);
    const std::int64_t right = minus(b.y, a.y) * minus(c.x, a.x);
    return static_cast<std::int64_t>(static_cast<std::uint64_t>(left) -
                                     static_cast<std::uint64_t>(right));
}

inline bool strictly_on_one_side(std::int64_t s, std::int64_t t) {
    return s != 0 && t != 0 && (s ^ t) >= 0;
}

inline bool boxes_overlap(const Line& p, const Line& q) {
    const auto apart = [](std::int32_t p1, std::int32_t p2, std::int32_t q1, std::int32_t q2) {
        return std::max(p1, p2) < std::min(q1, q2) || std::max(q1, q2) < std::min(p1, p2);
    };
    return !apart(p.a.x, p.b.x, q.a.x, q.b.x) && !apart(p.a.y, p.b.y, q.a.y, q.b.y);
}

// Constant time: at most 8 multiplications.
inline bool cross(const Line& p, const Line& q) {
    return boxes_overlap(p, q) && !strictly_on_one_side(side(p.a, p.b, q.a), side(p.a, p.b, q.b)) &&
           !strictly_on_one_side(side(q.a, q.b, p.a), side(q.a, q.b, p.b));
}

// "Two shapes are said to intersect if any of their lines are intersecting" (the introduction): a
// shape inside another does not.  As the paper leaves it: every line against every line until one
// meets, O(lines x lines).
template <class Counter>
bool cross(const Polygon& p, const Polygon& q, Counter& counter) {
    for (unsigned i = 0; i < p.count; ++i)
        for (unsigned j = 0; j < q.count; ++j) {
            counter.line_test();
            if (cross(p.lines[i], q.lines[j])) return true;
        }
    return false;
}

}  // namespace collision
