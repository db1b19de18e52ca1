// reference.h - what a tick should have found, by the simplest means.
#pragma once

#include "contender.h"

namespace bench {

// In order.  Sorts by min.x and compares each box with all that begin within it: O(n sqrt(n)) at
// best.
collision::PairList reference(const Boxes& boxes);

// Sorts `found`; a pair found twice is as wrong as one that is missing.
bool agrees(collision::PairList& found, const collision::PairList& reference);

}  // namespace bench
