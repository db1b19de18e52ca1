// box_cells.h - a kernel of Strips: the cell that each box begins in, and which boxes go on beyond.
#pragma once

#include "collision/broad/box_list.h"
#include "collision/broad/columns.h"
#include "collision/broad/grid_parts.h"

namespace collision {

constexpr unsigned BOX_CELLS_SLACK = 8;  // places that box_cells() may write beyond the last

// offset_in(), lane by lane.
template <class Ints>
[[gnu::always_inline]] inline auto offsets_in(std::int32_t first, std::int32_t last, Ints at) {
    const Ints least = first - Ints{}, most = last - Ints{};
    at = at > least ? at : least;
    at = at < most ? at : most;
    using Unsigned [[gnu::vector_size(sizeof(Ints))]] = std::uint32_t;
    return reinterpret_cast<Unsigned>(at) - reinterpret_cast<Unsigned>(least);
}

template <class Lanes, class Box>
[[gnu::always_inline]] inline unsigned cells_of(const Box* boxes, unsigned count,
                                                const GridParts& parts, std::uint32_t* cells,
                                                std::uint32_t* tall) {
    using Ints = typename Lanes::Ints;
    const GridParts grid = parts;
    std::uint32_t* next = tall;
    Ints indices;
    for (unsigned i = 0; i < Lanes::INTS; ++i) indices[i] = static_cast<std::int32_t>(i);
    const auto strip_of = [&grid](Ints y) __attribute__((always_inline)) {
        const StripParts& to = grid.strips;
        return (offsets_in(to.first, to.last, y) >> to.shift) * to.scale >> 16;
    };
    const auto vector = [&](unsigned i, const Box* from) __attribute__((always_inline)) {
        const auto box =
            columns<Lanes>([from](unsigned k) __attribute__((always_inline))->const Box& {
                return from[k];
            });
        const auto strip = strip_of(box.min_y);
        const BucketParts& to = grid.buckets;
        const auto cell = strip * to.count + (offsets_in(to.first, to.last, box.min_x) >> to.shift);
        std::memcpy(cells + i, &cell, sizeof cell);
        next += Lanes::collect(next, indices + static_cast<std::int32_t>(i),
                               reinterpret_cast<Ints>(strip_of(box.max_y) != strip));
    };
    unsigned i = 0;
    for (; i + Lanes::INTS <= count; i += Lanes::INTS) vector(i, boxes + i);
    if (i < count) {
        Box rest[Lanes::INTS] = {};  // filled up with points, which are not tall
        std::copy(boxes + i, boxes + count, rest);
        vector(i, rest);
    }
    return static_cast<unsigned>(next - tall);
}

// Writes the cell of each box's lower left corner to `cells`, and those boxes that reach into
// further strips to `tall`, in order.  Returns how many these are.  O(count), without a branch.
template <class Lanes>
unsigned box_cells(const BoxList& list, const GridParts& parts, std::uint32_t* cells,
                   std::uint32_t* tall) {
    return list.boxes     ? cells_of<Lanes>(list.boxes, list.count, parts, cells, tall)
           : list.entries ? cells_of<Lanes>(list.entries, list.count, parts, cells, tall)
                          : cells_of<Lanes>(list.packed, list.count, parts, cells, tall);
}

}  // namespace collision
