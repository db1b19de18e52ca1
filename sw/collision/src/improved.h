// improved.h - the paper's "improved algorithm": sorted intervals on two axes, then lines.
//
// Section "Improvement to the initial algorithm"; intervals.h is its core.  `pairs` is replaced by
// what is found, in lexicographic order.  n shapes of m lines, k overlaps on an axis, b overlapping
// boxes: O(n log n + k log k + n k), and b m^2 line tests.
#pragma once

#include "collision/collision_pair.h"
#include "collision/polygon.h"
#include "collision/tally.h"

namespace collision {

// With the open shapes in a linked list.
template <class Counter>
void find_improved(Polygons shapes, PairList& pairs, Counter& counter);

// With the open shapes in a vector, from the paper's conclusions: "Another thing that might be a
// slowdown is the use of a linked list".
template <class Counter>
void find_improved_vector(Polygons shapes, PairList& pairs, Counter& counter);

}  // namespace collision
