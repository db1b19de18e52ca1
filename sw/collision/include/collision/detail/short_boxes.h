// short_boxes.h - boxes of 16-bit coordinates, one array per edge, for brute force by vectors.
#pragma once

#include <array>
#include <cstdint>

#include "collision/polygon.h"

namespace collision::detail {

// Every coordinate is moved and shifted right so that the wider axis fits 16 bits.  Rounding down
// keeps the order of any two numbers, so boxes that overlap also overlap here.  The converse can
// fail only for boxes that are less than one 65,535th of the world apart.
struct ShortBoxes {
    static constexpr unsigned CAPACITY = 256;
    static constexpr unsigned PADDING = 8;  // a vector may begin at the last box

    using Edges = std::array<std::int16_t, CAPACITY + PADDING>;
    Edges min_x, min_y, max_x, max_y;

    void assign(const Aabb* boxes, unsigned count);  // count <= CAPACITY.  O(count)
};

}  // namespace collision::detail
