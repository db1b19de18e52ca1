// window.h - which lines of a polygon reach into a box.
#pragma once

#include "collision/broad/lanes.h"
#include "collision/polygon.h"

namespace collision {

static_assert(Polygon::MAX_LINES <= 32, "a bit a line");

#if defined(__SSE2__)
using BaseLanes = lanes::Sse2;
#elif defined(__ARM_NEON)
using BaseLanes = lanes::Neon;
#else
using BaseLanes = lanes::Plain;
#endif

// A line as a vector: x and y of one end, x and y of the other.
using Ends = BaseLanes::Ints;

// A line is left out if both its ends lie beyond the same side of the box.  One that passes by a
// corner may be kept: it is for the line test to say.
class Window {
public:
    explicit Window(const Aabb& box)
        : min_{box.min.x, box.min.y, box.min.x, box.min.y},
          max_{box.max.x, box.max.y, box.max.x, box.max.y} {}

    // Bit i is 1 where line i of `polygon` may reach into the box.  O(lines), without a branch but
    // for the loop's.
    unsigned reached_by(const Polygon& polygon) const {
        unsigned lines = 0;
        for (unsigned i = 0; i < polygon.count; ++i)
            lines |= static_cast<unsigned>(!misses(lanes::load<Ends>(&polygon.lines[i]))) << i;
        return lines;
    }

private:
    bool misses(Ends ends) const {
        const Ends below = ends<min_, above = ends> max_;
        return BaseLanes::int_bits((below & exchanged(below)) | (above & exchanged(above))) != 0;
    }

    static Ends exchanged(Ends ends) { return __builtin_shufflevector(ends, ends, 2, 3, 0, 1); }

    Ends min_, max_;
};

// Calls visit(line) for each bit, from line 0 on, until one call returns true, and returns whether
// one did.
template <class Visit>
bool any_line(const Polygon& polygon, unsigned lines, Visit visit) {
    for (; lines; lines &= lines - 1)
        if (visit(polygon.lines[lanes::lowest_bit(lines)])) return true;
    return false;
}

}  // namespace collision
