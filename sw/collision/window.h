// window.h - which lines of a polygon reach into a box.
#pragma once

#include "collision/four.h"
#include "collision/polygon.h"

namespace collision {

static_assert(Polygon::MAX_LINES <= 32, "a bit a line");

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
            lines |= static_cast<unsigned>(!misses(four(polygon.lines[i]))) << i;
        return lines;
    }

private:
    bool misses(Four ends) const {
        const Four below = ends<min_, above = ends> max_;
        return any((below & exchanged(below)) | (above & exchanged(above)));
    }

    // x and y, as of one end of a line, and again, as of the other.
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

}  // namespace collision
