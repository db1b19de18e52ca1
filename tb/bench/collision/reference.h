// reference.h - the pairs that a tick must find, computed in the simplest way.
#pragma once

#include "contender.h"

namespace bench {

// In order.  Sorts by min.x and compares each box with all that begin within it: O(n sqrt(n)) at
// best.
collision::PairList reference(const Boxes& boxes);

// Sorts `found`; a duplicate pair is an error like a missing one.
bool agrees(collision::PairList& found, const collision::PairList& reference);

}  // namespace bench
