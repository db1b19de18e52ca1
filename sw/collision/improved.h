// improved.h - the paper's "improved algorithm": sorted intervals on each axis.
//
//      ( a   ( b   ) a   ( c   ) b   ) c        on one axis: a-b and b-c, not a-c (Fig. 4)
//
// Section "Improvement to the initial algorithm", Fig. 5: sort the ends of all boxes along an axis,
// walk them with a list of the shapes now open, and pair whatever opens with all that is open.  The
// pairs of both axes, intersected, are the overlapping boxes; their lines decide.
//
// n shapes of m lines, k overlaps on an axis, b overlapping boxes: O(n log n) to sort, O(k log k)
// to keep the sets, up to O(n) to find a shape in the list when it closes, b m^2 line tests.
#pragma once

#include "collision/collision_pair.h"
#include "collision/polygons.h"

namespace collision {

Pairs find_improved(Polygons shapes);

}  // namespace collision
