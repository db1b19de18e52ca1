// original.h - the paper's "original algorithm": every shape against every other shape.
//
// Reference [2]'s algorithm 1, section "Detecting AABB collisions", equations (1) to (4), and Figs.
// 2 and 3: boxes by centre and half width first, lines against lines where the boxes overlap.
//
// n shapes of m lines, k overlapping boxes: n (n - 1) box tests, 2 k m^2 line tests (each pair is
// met from both sides), O(log n) to insert a pair.
#pragma once

#include "collision/collision_pair.h"
#include "collision/polygons.h"

namespace collision {

Pairs find_original(Polygons shapes);

}  // namespace collision
