// vec2.h - a point or vector on the fixed-point grid all geometry lives on.
#pragma once

#include <cstdint>

namespace collision {

constexpr std::int32_t PIXEL = 65536;  // grid units

// Every |coordinate| is below this.  A difference then fits 32 bits and a product of two
// differences fits 64, which makes the line test exact.
constexpr std::int32_t COORDINATE_LIMIT = 1 << 30;  // 16384 pixels

struct Vec2 {
    std::int32_t x = 0, y = 0;

    friend bool operator==(Vec2 a, Vec2 b) { return a.x == b.x && a.y == b.y; }
    friend bool operator!=(Vec2 a, Vec2 b) { return !(a == b); }
};

}  // namespace collision
