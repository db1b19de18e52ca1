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
    static constexpr unsigned PADDING = 16;  // a vector may begin at the last box

    using Edges = std::array<std::int16_t, CAPACITY + PADDING>;
    Edges min_x, min_y, max_x, max_y;

    void assign(const Aabb* boxes, unsigned count);  // count <= CAPACITY.  O(count)
};

// One vector with boxes that overlap box `box`: bit `stride` * i stands for the box `other` + i.
struct ShortHit {
    std::uint64_t bits;  // not 0
    std::uint32_t box, other;
};

// A branch on whether a vector has a hit would often be mispredicted.  So hits are first stored
// without a branch, and split into pairs afterwards.
struct ShortHits {
    static constexpr unsigned A_ROW = ShortBoxes::CAPACITY / 8;  // vectors, at most

    std::array<ShortHit, 8 * A_ROW> hits;
    unsigned count;
    unsigned stride;  // bits per box
};

}  // namespace collision::detail
