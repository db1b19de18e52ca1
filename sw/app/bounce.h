// bounce.h - what a collision does to the bodies in it.
//
// Velocities change as between two elastic balls: along the line between the centres, only when
// approaching, with mass by area, so that energy and momentum stay.  Positions are also pushed
// apart a little a tick for as long as the contact lasts: without it, shapes that entangle as they
// turn, or that begin on top of each other with equal velocities, would stay together.
//
// Not handled: collisions do not change the spin.
#pragma once

#include "app/body.h"

namespace app {

// Also their index among the polygons of a world.
enum Edge : unsigned { LEFT, RIGHT, TOP, BOTTOM, EDGES };

constexpr std::int32_t PUSH = collision::PIXEL / 4;  // a tick, per body

void bounce(Body& a, Body& b);  // centres at most 2 * MAX_SIZE pixels apart on each axis

void bounce_off(Edge edge, Body& body);

}  // namespace app
