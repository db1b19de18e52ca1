// narrow.h - do the lines of two polygons meet?  Only lines that reach where they could are tested.
//
// A common point lies in both boxes, so in their intersection, the window; so does a part of each
// line through it.  Beyond the paper, which tests all lines; it is how clipping begins (Cohen and
// Sutherland: a line is out if both its ends are beyond one side).
#pragma once

#include <algorithm>
#include <cstddef>

#include "collision/crossing.h"
#include "collision/pair_list.h"
#include "collision/polygons.h"
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
    const unsigned p_lines = window.reached_by(p);
    const unsigned q_lines = p_lines ? window.reached_by(q) : 0;
    return any_line(p, p_lines, [&](const Line& of_p) {
        return any_line(q, q_lines, [&](const Line& of_q) {
            counter.line_test();
            return cross(of_p, of_q);
        });
    });
}

// Writes those of `count` pairs that meet, in their order, from `out` on, and returns the end of
// them.  `out` has room for all, and may be where the pairs are.  Indices must exist.
using KeepMeeting = CollisionPair* (*)(Polygons shapes, const CollisionPair* pairs,
                                       std::size_t count, CollisionPair* out);

CollisionPair* keep_meeting(Polygons shapes, const CollisionPair* pairs, std::size_t count,
                            CollisionPair* out);

// The same for processors with AVX2, or nullptr where this one has it not: four lines of one
// polygon at a time against each of the other, and no branch that depends on a single line.
KeepMeeting keep_meeting_avx2();

}  // namespace collision
