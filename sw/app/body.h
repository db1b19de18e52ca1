// body.h - one shape that moves: where it is, how it moves, what it looks like.
#pragma once

#include <cstdint>

#include "app/shapes.h"
#include "app/sine.h"
#include "collision/vec2.h"
#include "gfx/colour.h"

namespace app {

// A velocity has eight more fraction bits than a position, so that the rounding errors of a
// thousand collisions stay invisible.
constexpr std::int32_t PIXEL_PER_TICK = collision::PIXEL * 256;
constexpr std::int32_t MAX_VELOCITY = 8 * PIXEL_PER_TICK;  // on each axis, in either direction

struct Body {
    collision::Vec2 position;  // grid units
    collision::Vec2 velocity;  // PIXEL_PER_TICK
    Angle angle = 0;
    std::int32_t spin = 0;  // angle per tick
    Shape shape = Shape::SQUARE;
    unsigned size = MIN_SIZE;  // pixels across
    gfx::Colour colour = gfx::WHITE;
};

inline std::int64_t mass(const Body& body) { return std::int64_t{body.size} * body.size; }

}  // namespace app
