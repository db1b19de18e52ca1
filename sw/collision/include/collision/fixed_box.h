// fixed_box.h - a box made once that no rotation can leave, moved by the velocity.
//
// From the paper's conclusions: "assign an AABB to a shape upon creation, large enough that no
// rotation could make the shape extend outside of the AABB.  Then, the AABB could just be updated
// by the velocity of the Polygon every tick".  Put it into Polygon::aabb in place of the box by
// update(): every algorithm uses boxes as they are.  Larger boxes overlap more often, so more lines
// are tested; the pairs found are the same.
#pragma once

#include "collision/polygon.h"

namespace collision {

// A square about `centre` that contains the polygon after any turned() about it.  O(lines), with a
// square root.  OUTSIDE_GRID, and `box` unchanged, if it reaches beyond the grid; TOO_MANY_LINES.
Error fixed_box(const Polygon& polygon, Vec2 centre, Aabb& box);

// O(1).  The result must be on the grid: a Detector refuses it otherwise.
Aabb moved(const Aabb& box, Vec2 by);

}  // namespace collision
