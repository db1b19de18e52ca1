// pair_set.h - pairs as the paper keeps them: a std::set in lexicographic order.
#pragma once

#include <set>

#include "collision/collision_pair.h"

namespace collision {

using PairSet = std::set<CollisionPair>;

}  // namespace collision
