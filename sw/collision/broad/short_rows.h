// short_rows.h - the kernel of Simd: all against all over 16-bit boxes, a vector at a time.
#pragma once

#include <array>
#include <cstdint>

#include "collision/broad/lanes.h"
#include "collision/broad/short_boxes.h"

namespace collision {

// One vector in which a box found others: bit stride * i stands for the box `other` + i.
struct ShortHit {
    std::uint64_t bits;  // not 0
    std::uint32_t box, other;
};

// Hits are collected first and told apart later: whether a vector has any is hard to foresee, and
// to write it down costs less than to branch on it.
struct ShortHits {
    static constexpr unsigned A_ROW = ShortBoxes::CAPACITY / 8;  // vectors, at most

    std::array<ShortHit, 8 * A_ROW> hits;
    unsigned count;
    unsigned stride;  // bits a box
};

// Compares the boxes from `row` on with those after them.  Stops where `hits` may be full and
// returns the row to go on with, or `count` at the end.
template <class Lanes>
unsigned short_rows(const ShortBoxes& shorts, unsigned count, unsigned row, ShortHits& hits) {
    using Shorts = typename Lanes::Shorts;
    ShortHit* next = hits.hits.data();
    const ShortHit* const last = next + hits.hits.size() - ShortHits::A_ROW;
    for (; row < count && next < last; ++row) {
        const Shorts min_x = shorts.min_x[row] - Shorts{}, max_x = shorts.max_x[row] - Shorts{};
        const Shorts min_y = shorts.min_y[row] - Shorts{}, max_y = shorts.max_y[row] - Shorts{};
        for (unsigned j = row + 1; j < count; j += Lanes::SHORTS) {
            const Shorts apart = (lanes::load<Shorts>(&shorts.min_x[j]) > max_x) |
                                 (lanes::load<Shorts>(&shorts.max_x[j]) < min_x) |
                                 (lanes::load<Shorts>(&shorts.min_y[j]) > max_y) |
                                 (lanes::load<Shorts>(&shorts.max_y[j]) < min_y);
            const std::uint64_t bits = Lanes::bits(~apart);
            *next = {bits, row, j};
            next += bits != 0;
        }
    }
    hits.count = static_cast<unsigned>(next - hits.hits.data());
    hits.stride = Lanes::STRIDE;
    return row;
}

}  // namespace collision
