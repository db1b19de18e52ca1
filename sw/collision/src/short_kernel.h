// short_kernel.h - the inner loop of Simd: all against all over 16-bit boxes, a vector at a time.
#pragma once

#include "collision/detail/short_boxes.h"
#include "lanes.h"

namespace collision::detail {

template <class Lanes>
unsigned compare_all(const ShortBoxes& boxes, unsigned count, unsigned row, ShortHits& hits) {
    using Shorts = typename Lanes::Shorts;
    ShortHit* next = hits.hits.data();
    const ShortHit* const last = next + hits.hits.size() - ShortHits::A_ROW;
    for (; row < count && next < last; ++row) {
        const Shorts min_x = boxes.min_x[row] - Shorts{}, max_x = boxes.max_x[row] - Shorts{};
        const Shorts min_y = boxes.min_y[row] - Shorts{}, max_y = boxes.max_y[row] - Shorts{};
        for (unsigned j = row + 1; j < count; j += Lanes::SHORTS) {
            const Shorts apart = (lanes::load<Shorts>(&boxes.min_x[j]) > max_x) |
                                 (lanes::load<Shorts>(&boxes.max_x[j]) < min_x) |
                                 (lanes::load<Shorts>(&boxes.min_y[j]) > max_y) |
                                 (lanes::load<Shorts>(&boxes.max_y[j]) < min_y);
            const std::uint64_t bits = Lanes::bits(~apart);
            *next = {bits, row, j};
            next += bits != 0;
        }
    }
    hits.count = static_cast<unsigned>(next - hits.hits.data());
    hits.stride = Lanes::STRIDE;
    return row;
}

}  // namespace collision::detail
