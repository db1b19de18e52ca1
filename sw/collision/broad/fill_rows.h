// fill_rows.h - a kernel of Strips: boxes fetched in their order and turned into an array an edge.
#pragma once

#include <limits>
#include <type_traits>

#include "collision/broad/box_list.h"
#include "collision/broad/columns.h"

namespace collision {

// In place of min.y: the box also lies in a strip below.
constexpr std::int32_t VISITOR = std::numeric_limits<std::int32_t>::min();

// In an order: this box as a visitor.
constexpr std::uint32_t AS_VISITOR = 0x80000000;

struct RowArrays {
    std::int32_t *min_x, *max_x, *min_y, *max_y;
    std::uint32_t* index;
};

template <class Lanes, class Box>
[[gnu::always_inline]] inline void rows_of(const Box* boxes, const RowArrays& arrays,
                                           std::size_t from, std::size_t to) {
    using Ints = typename Lanes::Ints;
    const RowArrays rows = arrays;
    const Ints visitor = VISITOR - Ints{};
    for (std::size_t i = from; i < to; i += Lanes::INTS) {
        const auto order = lanes::load<Ints>(rows.index + i);
        const Ints bare = order & ~visitor;
        std::memcpy(rows.index + i, &bare, sizeof bare);
        const auto box = columns<Lanes>(
            [&](unsigned k) [[gnu::always_inline]] { return box_of(boxes[rows.index[i + k]]); });
        if constexpr (std::is_same_v<Box, Entry>)
            for (std::size_t k = i; k < i + Lanes::INTS; ++k)
                rows.index[k] = boxes[rows.index[k]].index;
        const Ints min_y = order < 0 ? visitor : box.min_y;
        std::memcpy(rows.min_x + i, &box.min_x, sizeof(Ints));
        std::memcpy(rows.max_x + i, &box.max_x, sizeof(Ints));
        std::memcpy(rows.min_y + i, &min_y, sizeof(Ints));
        std::memcpy(rows.max_y + i, &box.max_y, sizeof(Ints));
    }
}

// index[from .. to) says which box belongs there, with AS_VISITOR or without; becomes what the box
// is called, and the other arrays are filled.  Up to 7 places after `to` are read and written as
// well: there must be numbers of boxes.  O(to - from).
template <class Lanes>
void fill_rows(const BoxList& list, const RowArrays& rows, std::size_t from, std::size_t to) {
    list.boxes ? rows_of<Lanes>(list.boxes, rows, from, to)
               : rows_of<Lanes>(list.entries, rows, from, to);
}

}  // namespace collision
