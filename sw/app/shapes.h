// shapes.h - the six shapes, and how one becomes a polygon on the screen.
#pragma once

#include <array>
#include <cstdint>

#include "app/sine.h"
#include "collision/polygon.h"

namespace app {

// In the order of their keys, 1 to 6.
enum class Shape : std::uint8_t { SQUARE, X, TRIANGLE, PENTAGON, ARROW, STAR };

constexpr unsigned SHAPES = 6;
constexpr unsigned MIN_SIZE = 12, MAX_SIZE = 20;  // pixels across: the circle around the shape

collision::Polygon polygon(Shape shape, collision::Vec2 centre, Angle angle, unsigned size);

}  // namespace app
