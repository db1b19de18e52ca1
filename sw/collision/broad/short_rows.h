// short_rows.h - the kernel of Simd: all against all over 16-bit boxes, a vector at a time.
#pragma once

#include "collision/broad/kernels.h"
#include "collision/broad/lanes.h"
#include "collision/broad/overlap.h"

namespace collision {

template <class Lanes>
unsigned short_rows(const ShortBoxes& shorts, const Aabb* boxes, unsigned count, unsigned row,
                    PairRoom& room) {
    using Shorts = typename Lanes::Shorts;
    for (; row < count && room.left() >= count; ++row) {
        const Shorts min_x = shorts.min_x[row] - Shorts{}, max_x = shorts.max_x[row] - Shorts{};
        const Shorts min_y = shorts.min_y[row] - Shorts{}, max_y = shorts.max_y[row] - Shorts{};
        for (unsigned j = row + 1; j < count; j += Lanes::SHORTS) {
            const Shorts apart = (lanes::load<Shorts>(&shorts.min_x[j]) > max_x) |
                                 (lanes::load<Shorts>(&shorts.max_x[j]) < min_x) |
                                 (lanes::load<Shorts>(&shorts.min_y[j]) > max_y) |
                                 (lanes::load<Shorts>(&shorts.max_y[j]) < min_y);
            for (auto bits = Lanes::bits(~apart); bits != 0; bits &= bits - 1) {
                const unsigned other = j + lanes::lowest_bit(bits) / Lanes::STRIDE;
                room.append(row, other, shorts.exact || overlap(boxes[row], boxes[other]));
            }
        }
    }
    return row;
}

}  // namespace collision
