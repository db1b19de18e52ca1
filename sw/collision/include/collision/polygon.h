// polygon.h - a shape as the algorithms see it: its lines, and the box around them.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "collision/error.h"
#include "collision/vec2.h"

namespace collision {

struct Line {
    Vec2 a, b;  // closed: both ends belong to it
};

// Axis-aligned bounding box, closed: boxes that only touch overlap.
struct Aabb {
    Vec2 min, max;
};

// Lines need not be connected, and may be of no length (a point).  Every algorithm uses `aabb` as
// it is, so it must contain all lines: a tight box by update(), or one of fixed_box.h.  If it does
// not, pairs may be missed; nothing worse happens.
struct Polygon {
    static constexpr unsigned MAX_LINES = 16;

    Aabb aabb{};
    unsigned count = 0;  // of lines in use; a polygon of none collides with nothing
    alignas(16) std::array<Line, MAX_LINES> lines{};  // one vector register each

    // Joins `corners` into a closed outline (one corner: a point) and measures its box.
    // TOO_MANY_LINES or OUTSIDE_GRID, and nothing is changed.  O(corners).
    Error outline(const Vec2* corners, unsigned corner_count);

    // Measures the AABB by plain min/max over all lines, as the paper does every tick (the end of
    // its section "Detecting collisions generally"): O(lines).  `count` is at most MAX_LINES.
    void update();
};

// A view of an array of polygons, which the caller owns.
class Polygons {
public:
    Polygons(const Polygon* first, std::size_t count) : first_{first}, count_{count} {}
    Polygons(const std::vector<Polygon>& all) : Polygons{all.data(), all.size()} {}

    unsigned size() const { return static_cast<unsigned>(count_); }
    const Polygon& operator[](std::size_t i) const { return first_[i]; }

private:
    const Polygon* first_;
    std::size_t count_;
};

}  // namespace collision
