// grid.h - from floating-point pixels to the grid: the only function that can be given a NaN.
#pragma once

#include "collision/error.h"
#include "collision/vec2.h"

namespace collision {

// Pixels to grid units (PIXEL to a pixel), rounded to the nearest, halves away from zero.
// NOT_FINITE, or OUTSIDE_GRID where the result would not be below COORDINATE_LIMIT in size (16384
// pixels); `point` is then unchanged.
Error to_grid(double x_pixels, double y_pixels, Vec2& point);

inline bool on_grid(std::int32_t coordinate) {
    return coordinate > -COORDINATE_LIMIT && coordinate < COORDINATE_LIMIT;
}

inline bool on_grid(Vec2 point) { return on_grid(point.x) && on_grid(point.y); }

}  // namespace collision
