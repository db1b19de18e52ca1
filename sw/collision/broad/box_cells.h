// box_cells.h - a kernel of Strips: the cell that each box begins in, and which boxes go on beyond.
#pragma once

#include "collision/broad/axis_parts.h"
#include "collision/broad/columns.h"

namespace collision {

constexpr unsigned BOX_CELLS_SLACK = 8;  // places that box_cells() may write beyond the last

template <class Lanes>
[[gnu::always_inline]] inline typename Lanes::Ints part_of(typename Lanes::Ints at,
                                                           const AxisParts& parts) {
    using Ints = typename Lanes::Ints;
    const Ints first = parts.first - Ints{}, last = parts.last - Ints{};
    at = at > first ? at : first;
    at = at < last ? at : last;
    using Unsigned [[gnu::vector_size(sizeof(Ints))]] = std::uint32_t;
    return reinterpret_cast<Ints>(reinterpret_cast<Unsigned>(at - first) >> parts.shift);
}

// Writes the cell of each box's lower left corner to `cells`, and those boxes that reach into
// further strips to `tall`, in order.  Returns how many these are.  O(count), without a branch.
template <class Lanes>
unsigned box_cells(const Aabb* boxes, unsigned count, const GridParts& parts, std::uint32_t* cells,
                   std::uint32_t* tall) {
    using Ints = typename Lanes::Ints;
    const GridParts grid = parts;
    std::uint32_t* next = tall;
    Ints indices;
    for (unsigned i = 0; i < Lanes::INTS; ++i) indices[i] = static_cast<std::int32_t>(i);
    const auto vector = [&](unsigned i, const Aabb* from) [[gnu::always_inline]] {
        const auto box =
            columns<Lanes>([from](unsigned k) [[gnu::always_inline]] { return from[k]; });
        const Ints strip = part_of<Lanes>(box.min_y, grid.strips);
        const Ints cell = strip * static_cast<std::int32_t>(grid.buckets.count) +
                          part_of<Lanes>(box.min_x, grid.buckets);
        std::memcpy(cells + i, &cell, sizeof cell);
        next += Lanes::collect(next, indices + static_cast<std::int32_t>(i),
                               part_of<Lanes>(box.max_y, grid.strips) > strip);
    };
    unsigned i = 0;
    for (; i + Lanes::INTS <= count; i += Lanes::INTS) vector(i, boxes + i);
    if (i < count) {
        Aabb rest[Lanes::INTS] = {};  // filled up with points, which are not tall
        std::copy(boxes + i, boxes + count, rest);
        vector(i, rest);
    }
    return static_cast<unsigned>(next - tall);
}

}  // namespace collision
