// polygon.cpp - see polygon.h
#include "collision/polygon.h"

#include <algorithm>

#include "collision/grid.h"

namespace collision {

Error Polygon::outline(const Vec2* corners, unsigned corner_count) {
    if (corner_count > MAX_LINES) return Error::TOO_MANY_LINES;
    if (!std::all_of(corners, corners + corner_count, [](Vec2 corner) { return on_grid(corner); }))
        return Error::OUTSIDE_GRID;
    for (unsigned i = 0; i < corner_count; ++i)
        lines[i] = {corners[i], corners[i + 1 < corner_count ? i + 1 : 0]};
    count = corner_count;
    update();
    return Error::NONE;
}

void Polygon::update() {
    aabb = count ? Aabb{lines[0].a, lines[0].a} : Aabb{};
    for (unsigned i = 0; i < count; ++i) {
        for (const Vec2 point : {lines[i].a, lines[i].b}) {
            aabb.min.x = std::min(aabb.min.x, point.x);
            aabb.min.y = std::min(aabb.min.y, point.y);
            aabb.max.x = std::max(aabb.max.x, point.x);
            aabb.max.y = std::max(aabb.max.y, point.y);
        }
    }
}

}  // namespace collision
