// grid.cpp - see grid.h
#include "collision/grid.h"

#include <cmath>

namespace collision {

Error to_grid(double x_pixels, double y_pixels, Vec2& point) {
    if (!std::isfinite(x_pixels) || !std::isfinite(y_pixels)) return Error::NOT_FINITE;
    const double x = std::round(x_pixels * PIXEL), y = std::round(y_pixels * PIXEL);
    if (!(std::abs(x) < COORDINATE_LIMIT && std::abs(y) < COORDINATE_LIMIT))
        return Error::OUTSIDE_GRID;
    point = {static_cast<std::int32_t>(x), static_cast<std::int32_t>(y)};
    return Error::NONE;
}

}  // namespace collision
