// pair_list.h - pairs in a flat array.
#pragma once

#include <vector>

#include "collision/collision_pair.h"

namespace collision {

using PairList = std::vector<CollisionPair>;

}  // namespace collision
