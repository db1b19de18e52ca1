// truth.h - what collides, by exact fractions in 128 bits: no boxes, no sides, none of the library.
#pragma once

#include <algorithm>
#include <vector>

#include "collision/collision_pair.h"
#include "collision/polygon.h"

namespace truth {

using collision::Line;
using collision::Polygon;
using collision::Vec2;
using Wide = __int128;

struct WideVec2 {
    Wide x, y;
};

inline WideVec2 minus(Vec2 a, Vec2 b) { return {Wide{a.x} - b.x, Wide{a.y} - b.y}; }
inline Wide cross_product(WideVec2 a, WideVec2 b) { return a.x * b.y - a.y * b.x; }
inline Wide dot_product(WideVec2 a, WideVec2 b) { return a.x * b.x + a.y * b.y; }

inline bool within(Wide numerator, Wide denominator) {
    if (denominator < 0) numerator = -numerator, denominator = -denominator;
    return numerator >= 0 && numerator <= denominator;
}

inline bool on_line(Vec2 point, const Line& line) {
    const WideVec2 along = minus(line.b, line.a), to = minus(point, line.a);
    if (along.x == 0 && along.y == 0) return to.x == 0 && to.y == 0;
    return cross_product(along, to) == 0 &&
           within(dot_product(to, along), dot_product(along, along));
}

// Parameters along both lines as fractions; parallel lines, and points, by their ends.
inline bool meet(const Line& p, const Line& q) {
    const WideVec2 r = minus(p.b, p.a), s = minus(q.b, q.a), between = minus(q.a, p.a);
    const Wide turn = cross_product(r, s);
    if (turn == 0) return on_line(p.a, q) || on_line(p.b, q) || on_line(q.a, p) || on_line(q.b, p);
    return within(cross_product(between, s), turn) && within(cross_product(between, r), turn);
}

inline bool meet(const Polygon& p, const Polygon& q) {
    for (unsigned k = 0; k < p.count; ++k)
        for (unsigned l = 0; l < q.count; ++l)
            if (meet(p.lines[k], q.lines[l])) return true;
    return false;
}

// Where all of a polygon's lines lie on an axis.
struct Extent {
    std::int32_t low, high;
};

inline Extent extent(const Polygon& shape, std::int32_t Vec2::*axis) {
    Extent found{shape.lines[0].a.*axis, shape.lines[0].a.*axis};
    for (unsigned k = 0; k < shape.count; ++k)
        for (const Vec2 point : {shape.lines[k].a, shape.lines[k].b})
            found = {std::min(found.low, point.*axis), std::max(found.high, point.*axis)};
    return found;
}

inline bool apart(Extent a, Extent b) { return a.high < b.low || b.high < a.low; }

// In lexicographic order.  Shapes that are separate on an axis are skipped to save time.
inline collision::PairList pairs(const std::vector<Polygon>& shapes) {
    std::vector<Extent> x, y;
    for (const Polygon& shape : shapes) {
        x.push_back(extent(shape, &Vec2::x));
        y.push_back(extent(shape, &Vec2::y));
    }
    collision::PairList found;
    for (std::uint32_t i = 0; i < shapes.size(); ++i)
        for (std::uint32_t j = i + 1; j < shapes.size(); ++j)
            if (!apart(x[i], x[j]) && !apart(y[i], y[j]) && meet(shapes[i], shapes[j]))
                found.push_back({i, j});
    return found;
}

}  // namespace truth
