// bounce.h - what a collision does to the bodies in it.
//
// Velocities change as between two elastic balls: along the line between the centres, only when
// they approach, with masses proportional to the areas, so energy and momentum are conserved.  As
// long as the contact lasts, the positions are also pushed apart a little in each tick.  Without
// that, shapes that entangle as they turn, or that begin on top of each other with equal
// velocities, would stay together.
//
// Not handled: collisions do not change the spin.
#pragma once

#include "app/body.h"

namespace app {

// Also their index among the polygons of a world.
enum Edge : unsigned { LEFT, RIGHT, TOP, BOTTOM, EDGES };

constexpr std::int32_t PUSH = collision::PIXEL / 4;  // per tick and body

void bounce(Body& a, Body& b);  // centres at most 2 * MAX_SIZE pixels apart on each axis

void bounce_off(Edge edge, Body& body);

}  // namespace app
