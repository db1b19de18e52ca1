// narrow.h - do the lines of two polygons meet?  Only lines that reach where they could are tested.
//
// A common point lies in both boxes, so in their intersection, the window; so does a part of each
// line through it.  Beyond the paper, which tests all lines; it is how clipping begins (Cohen and
// Sutherland: a line is out if both its ends are beyond one side).
#pragma once

#include <algorithm>
#include <array>

#include "collision/crossing.h"
#include "collision/polygon.h"
#include "collision/window.h"

namespace collision {

inline Aabb intersection(const Aabb& a, const Aabb& b) {
    return {{std::max(a.min.x, b.min.x), std::max(a.min.y, b.min.y)},
            {std::min(a.max.x, b.max.x), std::min(a.max.y, b.max.y)}};
}

// True if and only if a line of `p` and one of `q` have a point in common, by the rule of
// crossing.h; exchanging the polygons changes nothing.  Both boxes contain their lines, and both
// counts are at most MAX_LINES.  O(lines) to clip, then O(lines of p x lines of q) of those inside
// the window, until two meet.
template <class Counter>
bool meet(const Polygon& p, const Polygon& q, Counter& counter) {
    const Window window{intersection(p.aabb, q.aabb)};
    std::array<Line, Polygon::MAX_LINES> of_p, of_q;
    const unsigned p_count = window.reached_by(p, of_p.data());
    if (!p_count) return false;
    const unsigned q_count = window.reached_by(q, of_q.data());
    for (unsigned i = 0; i < p_count; ++i)
        for (unsigned j = 0; j < q_count; ++j) {
            counter.line_test();
            if (cross(of_p[i], of_q[j])) return true;
        }
    return false;
}

}  // namespace collision
