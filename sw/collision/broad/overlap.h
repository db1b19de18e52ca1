// overlap.h - do two closed boxes have a point in common?
#pragma once

#include "collision/polygon.h"

namespace collision {

// Any int32 coordinates.  No branch: four comparisons.
inline bool overlap(const Aabb& a, const Aabb& b) {
    return (a.min.x <= b.max.x) & (b.min.x <= a.max.x) & (a.min.y <= b.max.y) &
           (b.min.y <= a.max.y);
}

}  // namespace collision
