// narrow.h - do the lines of two polygons meet?  Tests only lines that reach into both boxes.
//
// A common point lies in both boxes, so in their intersection, the window; so does a part of each
// line through it.  Beyond the paper, which tests all lines; it is how clipping begins (Cohen and
// Sutherland: a line is out if both its ends are beyond one side).
#pragma once

#include <algorithm>
#include <cstddef>

#include "collision/collision_pair.h"
#include "collision/crossing.h"
#include "collision/polygon.h"
#include "four.h"

namespace collision {

static_assert(Polygon::MAX_LINES <= 32, "a bit a line");

// A line is left out if both its ends lie beyond the same side of the box.  A line that passes
// outside a corner may be kept; the line test decides.
class Window {
public:
    explicit Window(const Aabb& box)
        : min_{box.min.x, box.min.y, box.min.x, box.min.y},
          max_{box.max.x, box.max.y, box.max.x, box.max.y} {}

    // Bit i is 1 where line i of `polygon` may reach into the box.  O(lines); the loop has the only
    // branch.
    unsigned reached_by(const Polygon& polygon) const {
        unsigned lines = 0;
        for (unsigned i = 0; i < polygon.count; ++i)
            lines |= static_cast<unsigned>(!misses(four(polygon.lines[i]))) << i;
        return lines;
    }

private:
    bool misses(Four ends) const {
        const Four below = ends<min_, above = ends> max_;
        return any((below & exchanged(below)) | (above & exchanged(above)));
    }

    // x and y twice: once for each end of a line.
    Four min_, max_;
};

// Calls visit(line) for each bit, from line 0 on, until one call returns true, and returns whether
// one did.
template <class Visit>
bool any_line(const Polygon& polygon, unsigned lines, Visit visit) {
    for (; lines; lines &= lines - 1)
        if (visit(polygon.lines[lowest_bit(lines)])) return true;
    return false;
}

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
//
// With AVX2 four lines of one polygon at a time are compared with each of the other, without a
// branch that depends on a single line.
CollisionPair* keep_meeting(Polygons shapes, const CollisionPair* pairs, std::size_t count,
                            CollisionPair* out);

}  // namespace collision
