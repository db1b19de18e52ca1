// strip_rows.h - the kernel of Strips: one strip's boxes in the order of x, a vector at a time.
#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>

#include "collision/broad/fill_rows.h"
#include "collision/broad/lanes.h"
#include "collision/broad/pair_room.h"

namespace collision {

// One strip: `count` boxes in the order of their buckets of min.x, an array an edge, and PADDING
// places more, with boxes to the right of all others that not even touch themselves.  The buckets
// are mask + 1 units wide, the first from `left` on; whatever is left of it belongs to it too, and
// to the last what is beyond `right`.  Two visitors are not this strip's pair.
struct StripRows {
    static constexpr unsigned PADDING = 32;

    const std::int32_t *min_x, *max_x, *min_y, *max_y;
    const std::uint32_t* index;
    unsigned count;
    std::int32_t left, right;
    std::uint32_t mask;
    std::int32_t narrowest;  // no box is narrower

    // Whether none of the boxes from `row` on to before `end` begins only after one has ended that
    // comes later: no box is narrower than a bucket, and none of these is in the first or the last
    // one, which know no limits.
    [[gnu::always_inline]] bool in_order(unsigned row, unsigned end) const {
        const std::int64_t second = std::int64_t{left} + mask + 1;
        const std::int64_t last =
            left +
            std::int64_t{(static_cast<std::uint32_t>(right) - static_cast<std::uint32_t>(left)) &
                         ~mask};
        return narrowest >= std::int64_t{mask} && std::min(min_x[row], right) >= second &&
               min_x[end - 1] < last;
    }

    // The end of the bucket that `at` belongs to: boxes in later buckets begin beyond.
    [[gnu::always_inline]] std::int32_t last_in_bucket(std::int32_t at) const {
        const auto origin = static_cast<std::uint32_t>(left);
        const auto clamped = static_cast<std::uint32_t>(std::min(std::max(at, left), right));
        const std::uint32_t last = (clamped - origin) | mask;
        return last < static_cast<std::uint32_t>(right) - origin
                   ? static_cast<std::int32_t>(last + origin)
                   : std::numeric_limits<std::int32_t>::max();
    }
};

// Writes the pairs of each row with those after it.
template <class Lanes>
void strip_rows(const StripRows& rows, PairRoom& to) {
    using Ints = typename Lanes::Ints;
    const StripRows strip = rows;  // copies, or each store of a vector might have changed them
    PairRoom room = to;
    for (unsigned row = 0; row < strip.count; ++row) {
        room.need(strip.count - row + Lanes::INTS);
        const std::int32_t reach = strip.last_in_bucket(strip.max_x[row]);
        const Ints min_x = strip.min_x[row] - Ints{}, max_x = strip.max_x[row] - Ints{};
        const Ints max_y = strip.max_y[row] - Ints{};
        // A box from below reaches over the lower edge of all others: the test that it need not
        // make is used to leave out those that are from below as well.
        const bool visitor = strip.min_y[row] == VISITOR;
        const std::int32_t* upper = visitor ? strip.min_y : strip.max_y;
        const Ints lower = strip.min_y[row] + visitor - Ints{};
        std::uint32_t j = row + 1;
        do {
            const Ints apart = (lanes::load<Ints>(strip.min_x + j) > max_x) |
                               (lanes::load<Ints>(strip.max_x + j) < min_x) |
                               (lanes::load<Ints>(strip.min_y + j) > max_y) |
                               (lanes::load<Ints>(upper + j) < lower);
            Lanes::append(room, strip.index[row], strip.index + j, ~apart);
            j += Lanes::INTS;
        } while (j < strip.count && strip.min_x[j] <= reach);
    }
    to = room;
}

}  // namespace collision
