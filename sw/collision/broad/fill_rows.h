// fill_rows.h - a kernel of Strips: boxes fetched in their order and turned into an array an edge.
#pragma once

#include <type_traits>

#include "collision/broad/columns.h"

namespace collision {

struct RowArrays {
    std::int32_t *min_x, *max_x, *min_y, *max_y;
    std::uint32_t* index;
};

constexpr unsigned FETCH_AHEAD = 16;      // boxes, where a processor does not look that far itself
constexpr unsigned FETCH_FROM = 1 << 15;  // boxes: as many as its second cache cannot hold
constexpr unsigned FILL_ROWS_SLACK = FETCH_AHEAD + 8;  // places that are read beyond the last

template <class Lanes, bool AHEAD, class Box>
[[gnu::always_inline]] inline void rows_of(const Box* boxes, const std::uint32_t* order,
                                           unsigned count, const RowArrays& arrays) {
    using Ints = typename Lanes::Ints;
    const RowArrays rows = arrays;  // a copy, or each vector that is written might have changed it
    const Ints visitor = VISITOR - Ints{};
    for (unsigned i = 0; i < count; i += Lanes::INTS) {
        if constexpr (AHEAD)
            for (unsigned k = 0; k < Lanes::INTS; ++k)
                __builtin_prefetch(boxes + (order[i + FETCH_AHEAD + k] & ~AS_VISITOR));
        const auto entries = lanes::load<Ints>(order + i);
        const Ints bare = entries & ~visitor;
        std::uint32_t which[Lanes::INTS];
        std::memcpy(which, &bare, sizeof bare);
        const auto box = columns<Lanes>([&](unsigned k) __attribute__((always_inline))->const Box& {
            return boxes[which[k]];
        });
        if constexpr (std::is_same_v<Box, Entry>)
            for (std::uint32_t& index : which) index = boxes[index].index;
        if constexpr (std::is_same_v<Box, PackedEntry>)
            std::memcpy(which, &box.index, sizeof which);
        const Ints min_y = entries < 0 ? visitor : box.min_y;
        std::memcpy(rows.min_x + i, &box.min_x, sizeof(Ints));
        std::memcpy(rows.max_x + i, &box.max_x, sizeof(Ints));
        std::memcpy(rows.min_y + i, &min_y, sizeof(Ints));
        std::memcpy(rows.max_y + i, &box.max_y, sizeof(Ints));
        std::memcpy(rows.index + i, which, sizeof which);
    }
}

// Fetches the boxes that order[0 .. count) names, with AS_VISITOR or without.  What the slack names
// must be boxes, too; up to 7 rows more are written.  O(count).
template <class Lanes>
void fill_rows(const BoxList& list, const std::uint32_t* order, unsigned count,
               const RowArrays& rows) {
    if (list.packed)
        rows_of<Lanes, false>(list.packed, order, count, rows);
    else if (list.entries)
        rows_of<Lanes, false>(list.entries, order, count, rows);
    else if (list.count < FETCH_FROM)
        rows_of<Lanes, false>(list.boxes, order, count, rows);
    else
        rows_of<Lanes, true>(list.boxes, order, count, rows);
}

}  // namespace collision
