// polygon.h - a shape as the algorithms see it: its lines, and the box around them.
#pragma once

#include <array>

#include "collision/vec2.h"

namespace collision {

struct Line {
    Vec2 a, b;  // closed: both ends belong to it
};

// Axis-aligned bounding box, closed: boxes that only touch overlap.
struct Aabb {
    Vec2 min, max;
};

struct Polygon {
    static constexpr unsigned MAX_LINES = 16;

    std::array<Line, MAX_LINES> lines{};
    unsigned count = 0;  // of lines in use; a polygon of none collides with nothing
    Aabb aabb{};         // as of the last update()

    // Joins `corners` into a closed outline.  False, and nothing changed, if MAX_LINES is too few.
    bool outline(const Vec2* corners, unsigned corner_count);

    // Measures the AABB by plain min/max over all lines, as the paper does every tick: O(lines).
    void update();
};

}  // namespace collision
