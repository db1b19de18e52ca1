// original.cpp - see original.h
#include "collision/original.h"

#include <cstdint>

#include "collision/crossing.h"

namespace collision {
namespace {

// Equations (1) and (3), or (2) and (4), on one axis.  Both sides are doubled, since a centre may
// lie between two grid points: 2 Len <= R_Width + R'_Width.
bool near_enough(std::int64_t min, std::int64_t max, std::int64_t other_min,
                 std::int64_t other_max) {
    const std::int64_t doubled_way = (min + max) - (other_min + other_max);
    const std::int64_t doubled_len = doubled_way < 0 ? -doubled_way : doubled_way;
    return doubled_len <= (max - min) + (other_max - other_min);
}

bool colliding(const Polygon& shape, const Polygon& other) {
    const Aabb &a = shape.aabb, &b = other.aabb;
    return near_enough(a.min.x, a.max.x, b.min.x, b.max.x) &&
           near_enough(a.min.y, a.max.y, b.min.y, b.max.y) && cross(shape, other);
}

}  // namespace

Pairs find_original(Polygons shapes) {
    Pairs pairs;
    for (unsigned i = 0; i < shapes.size(); ++i)
        for (unsigned j = 0; j < shapes.size(); ++j)
            if (i != j && colliding(shapes[i], shapes[j])) pairs.insert(pair_of(i, j));
    return pairs;
}

}  // namespace collision
