// draw.h - a world as a picture.
#pragma once

#include <cstdint>

#include "app/world.h"
#include "gfx/canvas.h"

namespace app {

// What the picture shows besides the world.
struct Overlay {
    std::uint32_t tick_us = 0;  // measured time of a tick
};

// Clears the canvas and draws all of it: the edges, shapes (white in a tick in which they collide),
// their boxes if asked for, PAUSED, and a line like "100 shapes  simd  1.23 ms".
void draw(const World& world, const Overlay& overlay, gfx::Canvas& canvas);

}  // namespace app
