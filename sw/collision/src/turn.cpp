// turn.cpp - see turn.h
#include "collision/turn.h"

#include <cstdint>

#include "collision/crossing.h"

namespace collision {
namespace {

template <class Change>
Polygon each_point(const Polygon& polygon, Change change) {
    Polygon changed = polygon;
    for (unsigned i = 0; i < changed.count; ++i) {
        Line& line = changed.lines[i];
        line = {change(line.a), change(line.b)};
    }
    changed.update();
    return changed;
}

std::int32_t wrapped(std::int64_t value) {
    return static_cast<std::int32_t>(static_cast<std::uint32_t>(value));
}

std::int32_t rounded(std::int64_t turned) { return wrapped((turned + TURN_ONE / 2) >> 16); }

}  // namespace

Polygon moved(const Polygon& polygon, Vec2 by) {
    return each_point(polygon, [by](Vec2 point) {
        return Vec2{wrapped(std::int64_t{point.x} + by.x), wrapped(std::int64_t{point.y} + by.y)};
    });
}

Polygon turned(const Polygon& polygon, Vec2 centre, Turn turn) {
    return each_point(polygon, [centre, turn](Vec2 point) {
        const std::int64_t x = minus(point.x, centre.x), y = minus(point.y, centre.y);
        return Vec2{wrapped(centre.x + std::int64_t{rounded(x * turn.cosine - y * turn.sine)}),
                    wrapped(centre.y + std::int64_t{rounded(x * turn.sine + y * turn.cosine)})};
    });
}

}  // namespace collision
