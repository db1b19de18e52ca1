// turn.h - polygons moved and turned on the grid.
#pragma once

#include "collision/polygon.h"

namespace collision {

constexpr std::int32_t TURN_ONE = 65536;

// A rotation, as TURN_ONE times its cosine and sine.  The pair may be off the unit circle by
// rounding, by at most one in each.
struct Turn {
    std::int32_t cosine = TURN_ONE, sine = 0;
};

// Both return the polygon with its box measured again.  Equal points stay equal, so lines that were
// joined stay joined.  O(lines).  The result must be on the grid.  If it is not, coordinates wrap,
// and a Detector refuses the polygon unless it wrapped back onto the grid.
Polygon moved(const Polygon& polygon, Vec2 by);

// Turns about `centre`; each coordinate is rounded to the nearest grid unit.  So turn the shape as
// created rather than that of the last tick, or rounding errors add up.
Polygon turned(const Polygon& polygon, Vec2 centre, Turn turn);

}  // namespace collision
