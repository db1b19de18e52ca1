// strip_rows.h - the kernel of Strips: one strip's boxes in the order of x, a vector at a time.
#pragma once

#include <cstdint>
#include <limits>

#include "collision/broad/lanes.h"
#include "collision/broad/pair_writer.h"

namespace collision {

// In place of min.y: the box also lies in a strip below.  Two such boxes are not this strip's pair.
constexpr std::int32_t VISITOR = std::numeric_limits<std::int32_t>::min();

// One strip: `count` boxes, an array an edge, and the same for PADDING boxes more, which lie to the
// right of all others.
struct StripRows {
    static constexpr unsigned PADDING = 8;

    const std::int32_t *min_x, *max_x, *min_y, *max_y;
    const std::uint32_t* index;
    const std::uint32_t* end;  // from here on all boxes begin to the right of this one
    unsigned count;
};

// Writes the pairs of each row from `row` on with those after it.  Stops before a row that `room`
// may be too small for and returns it, or `count` at the end.
template <class Lanes>
unsigned strip_rows(const StripRows& strip, unsigned row, PairRoom& room) {
    using Ints = typename Lanes::Ints;
    for (; row < strip.count; ++row) {
        const std::uint32_t end = strip.end[row];
        if (room.left() < end - row + Lanes::INTS) break;
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
        } while (j < end);
    }
    return row;
}

}  // namespace collision
