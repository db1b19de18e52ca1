// world.h - the whole state of the program as one value, and the step that leads to the next.
//
//      key     does
//      1 - 6   a new shape: square, X, triangle, pentagon, arrow, star
//      0       ten more of the last shape
//      A       the next collision algorithm
//      B       pause: shapes stand still, everything else goes on
//      C       clear: all shapes away
//      D       show the bounding boxes
//      E, F    slower, faster
//
// A new shape's place, size, velocity, spin and colour come from the seeded generator.  With
// CAPACITY shapes there, further ones are ignored; so are all other keys.
//
// A World takes about 80 KB, which may be too much for a stack.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "app/body.h"
#include "app/bounce.h"
#include "app/random.h"
#include "collision/detector.h"

namespace app {

struct World {
    static constexpr unsigned CAPACITY = 256;
    static constexpr unsigned SPEED_LEVELS = 5, NORMAL_SPEED = 2;  // each twice as fast as the last

    explicit World(std::uint32_t seed);

    std::array<Body, CAPACITY> bodies{};
    unsigned count = 0;  // of bodies in use

    // The four edges of the screen, then body i at EDGES + i; the indices in the pairs.
    std::array<collision::Polygon, EDGES + CAPACITY> polygons{};
    // Of this tick and of the one before, in lexicographic order.
    collision::PairList pairs, pairs_before;
    collision::Detector detector;  // only buffers: not part of the state

    collision::Algorithm algorithm = collision::BEST;
    bool paused = false;
    bool show_boxes = false;
    unsigned speed_level = NORMAL_SPEED;
    Shape last_shape = Shape::SQUARE;
    Random random;
    std::uint32_t tick = 0;  // steps so far, paused ones too
};

struct Input {
    std::string_view keys;  // pressed since the last step, in order: '0' - '9', 'A' - 'F'
};

// Same world and input, same next world, bit for bit.
void step(World& world, const Input& input);

// The three parts of a step, in order, to time the detection alone as the paper did.
void advance(World& world, const Input& input);  // keys, movement, polygons and their boxes
void find_pairs(World& world);                   // with the chosen algorithm
void respond(World& world);                      // new velocities

}  // namespace app
