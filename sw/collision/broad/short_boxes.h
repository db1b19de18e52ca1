// short_boxes.h - boxes in 16-bit fixed point, one array an edge, as the vectors want them.
#pragma once

#include <array>
#include <cstdint>

#include "collision/polygon.h"

namespace collision {

// Every coordinate is moved and shifted right so that the widest axis fits 16 bits.  Rounding down
// keeps the order of any two numbers, so boxes that overlap also overlap here; boxes less than one
// 65,535th of the world apart may overlap here alone.
struct ShortBoxes {
    static constexpr unsigned CAPACITY = 256;
    static constexpr unsigned PADDING = 16;  // a vector may begin at the last box

    using Edges = std::array<std::int16_t, CAPACITY + PADDING>;
    Edges min_x, min_y, max_x, max_y;

    // count <= CAPACITY.  O(count).
    void assign(const Aabb* boxes, unsigned count);
};

}  // namespace collision
