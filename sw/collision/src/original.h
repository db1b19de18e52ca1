// original.h - the paper's "original algorithm": every shape against every other shape.
//
// Reference [2]'s algorithm 1, section "Detecting AABB collisions", equations (1) to (4), and Figs.
// 2 and 3.  `pairs` is replaced by what is found, in lexicographic order.  n shapes of m lines, k
// ordered pairs of overlapping boxes; inserting a pair into the set costs O(log n).
#pragma once

#include "collision/collision_pair.h"
#include "collision/polygon.h"
#include "collision/tally.h"

namespace collision {

// As the paper describes it: boxes by centre and half width first, then lines against lines where
// the boxes overlap.  n (n - 1) box tests, up to k m^2 line tests: each pair is tested from both
// sides.
template <class Counter>
void find_original(Polygons shapes, PairList& pairs, Counter& counter);

// An interpretation under which its published times make sense: lines are tested for every ordered
// pair, even if the boxes do not overlap.  Up to n (n - 1) m^2 line tests.
template <class Counter>
void find_original_all_lines(Polygons shapes, PairList& pairs, Counter& counter);

// The same, and polygons, with their lines in a std::vector, are passed by value, as a function
// `colliding(Polygon, Polygon)` does: 2 n (n - 1) copies, each with an allocation.
template <class Counter>
void find_original_by_copy(Polygons shapes, PairList& pairs, Counter& counter);

}  // namespace collision
