// box_list.h - boxes, and what they are called.
#pragma once

#include <cstdint>

#include "collision/polygon.h"

namespace collision {

// Not owned.  Fewer than 2^31.
struct BoxList {
    const Aabb* boxes;
    const std::uint32_t* indices;  // null: 0, 1, 2 ...
    unsigned count;
};

}  // namespace collision
