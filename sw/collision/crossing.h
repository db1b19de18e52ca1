// crossing.h - do two lines, or the lines of two polygons, have a point in common?
//
// Two closed segments meet if and only if their closed boxes overlap and neither has both ends
// strictly on one side of the other.  That one rule covers crossing, touching, collinear and
// zero-length segments.  Exact: two 64-bit products are compared, never subtracted.
#pragma once

#include <algorithm>
#include <cstdint>

#include "collision/polygon.h"

namespace collision {

// 1: c lies to the left of the line from a to b (y up), -1: to the right, 0: on it.
inline int side(Vec2 a, Vec2 b, Vec2 c) {
    const std::int64_t left = std::int64_t{b.x - a.x} * (c.y - a.y);
    const std::int64_t right = std::int64_t{b.y - a.y} * (c.x - a.x);
    return (left > right) - (left < right);
}

inline bool cross(const Line& p, const Line& q) {
    const auto apart = [](std::int32_t p1, std::int32_t p2, std::int32_t q1, std::int32_t q2) {
        return std::max(p1, p2) < std::min(q1, q2) || std::max(q1, q2) < std::min(p1, p2);
    };
    if (apart(p.a.x, p.b.x, q.a.x, q.b.x) || apart(p.a.y, p.b.y, q.a.y, q.b.y)) return false;
    return side(p.a, p.b, q.a) * side(p.a, p.b, q.b) <= 0 &&
           side(q.a, q.b, p.a) * side(q.a, q.b, p.b) <= 0;
}

// "Two shapes are said to intersect if any of their lines are intersecting": a shape inside another
// does not.  O(lines x lines).
inline bool cross(const Polygon& p, const Polygon& q) {
    for (unsigned i = 0; i < p.count; ++i)
        for (unsigned j = 0; j < q.count; ++j)
            if (cross(p.lines[i], q.lines[j])) return true;
    return false;
}

}  // namespace collision
