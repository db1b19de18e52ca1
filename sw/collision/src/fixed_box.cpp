// fixed_box.cpp - see fixed_box.h
#include "collision/fixed_box.h"

#include <algorithm>
#include <cstdint>

#include "collision/crossing.h"
#include "collision/grid.h"

namespace collision {
namespace {

// The square root of `square`, rounded up to a whole number.
std::uint64_t root_rounded_up(std::uint64_t square) {
    std::uint64_t root = 0;
    for (std::uint64_t bit = std::uint64_t{1} << 31; bit; bit >>= 1)
        if ((root + bit) * (root + bit) <= square) root += bit;
    return root + (root * root < square);
}

}  // namespace

Error fixed_box(const Polygon& polygon, Vec2 centre, Aabb& box) {
    if (polygon.count > Polygon::MAX_LINES) return Error::TOO_MANY_LINES;
    if (!on_grid(centre)) return Error::OUTSIDE_GRID;
    std::uint64_t farthest = 0;  // squared
    for (unsigned i = 0; i < polygon.count; ++i)
        for (const Vec2 point : {polygon.lines[i].a, polygon.lines[i].b}) {
            if (!on_grid(point)) return Error::OUTSIDE_GRID;
            const std::int64_t x = minus(point.x, centre.x), y = minus(point.y, centre.y);
            farthest = std::max(farthest, static_cast<std::uint64_t>(x * x + y * y));
        }
    // A Turn may stretch by 2 / TURN_ONE, and its result is rounded by up to half a unit.
    const std::uint64_t radius = root_rounded_up(farthest);
    const auto reach = static_cast<std::int64_t>(radius + radius / (1 << 15) + 2);
    const auto [x, y] = centre;
    if (std::max(x, y) + reach >= COORDINATE_LIMIT || std::min(x, y) - reach <= -COORDINATE_LIMIT)
        return Error::OUTSIDE_GRID;
    const auto half = static_cast<std::int32_t>(reach);
    box = {{x - half, y - half}, {x + half, y + half}};
    return Error::NONE;
}

Aabb moved(const Aabb& box, Vec2 by) {
    const auto sum = [](std::int32_t a, std::int32_t b) {
        return static_cast<std::int32_t>(static_cast<std::uint32_t>(a) +
                                         static_cast<std::uint32_t>(b));
    };
    return {{sum(box.min.x, by.x), sum(box.min.y, by.y)},
            {sum(box.max.x, by.x), sum(box.max.y, by.y)}};
}

}  // namespace collision
