// sweep_kernel.h - the inner loop of Sweep and Strips: sorted boxes, a vector at a time.
#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>

#include "collision/detail/sorted_boxes.h"
#include "lanes.h"
#include "pair_writer.h"

namespace collision::detail {

// The last x of the bucket that `x` belongs to.  Boxes in later buckets begin to the right of it.
[[gnu::always_inline]] inline std::int32_t last_in_bucket(const SortedBoxes& boxes,
                                                          std::int32_t x) {
    const auto left = static_cast<std::uint32_t>(boxes.left);
    const auto inside = static_cast<std::uint32_t>(std::min(std::max(x, boxes.left), boxes.right));
    const std::uint32_t last = (inside - left) | boxes.mask;
    return last < static_cast<std::uint32_t>(boxes.right) - left
               ? static_cast<std::int32_t>(last + left)
               : std::numeric_limits<std::int32_t>::max();
}

// Writes the pairs of each box with those after it.  A box is compared with all up to the end of
// the bucket in which it ends, on all four edges.  A pair of two visitors does not belong to this
// strip.
template <class Lanes>
void sweep(const SortedBoxes& sorted, PairWriter& to) {
    using Ints = typename Lanes::Ints;
    const SortedBoxes boxes = sorted;  // a copy: stores might change the original
    PairWriter pairs = to;
    for (unsigned row = 0; row < boxes.count; ++row) {
        pairs.need(boxes.count - row + Lanes::INTS);
        const std::int32_t reach = last_in_bucket(boxes, boxes.max_x[row]);
        const Ints min_x = boxes.min_x[row] - Ints{}, max_x = boxes.max_x[row] - Ints{};
        const Ints max_y = boxes.max_y[row] - Ints{};
        // A visitor begins below all boxes that are at home here, so one of the four tests is not
        // needed.  That test is used to leave out the other visitors instead.
        const bool visitor = boxes.min_y[row] == VISITOR_MIN_Y;
        const std::int32_t* upper = visitor ? boxes.min_y : boxes.max_y;
        const Ints lower = boxes.min_y[row] + visitor - Ints{};
        std::uint32_t j = row + 1;
        do {
            const Ints apart = (lanes::load<Ints>(boxes.min_x + j) > max_x) |
                               (lanes::load<Ints>(boxes.max_x + j) < min_x) |
                               (lanes::load<Ints>(boxes.min_y + j) > max_y) |
                               (lanes::load<Ints>(upper + j) < lower);
            Lanes::append(pairs, boxes.index[row], boxes.index + j, ~apart);
            j += Lanes::INTS;
        } while (j < boxes.count && boxes.min_x[j] <= reach);
    }
    to = pairs;
}

}  // namespace collision::detail
