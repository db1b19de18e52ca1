// fill_rows.h - a kernel of Strips: boxes fetched in their order and turned into an array an edge.
#pragma once

#include <algorithm>
#include <limits>
#include <type_traits>

#include "collision/broad/columns.h"

namespace collision {

struct RowArrays {
    std::int32_t *min_x, *max_x, *min_y, *max_y;
    std::uint32_t* index;

    template <class Ints>
    [[gnu::always_inline]] void put(unsigned i, Ints left, Ints right, Ints lower, Ints upper,
                                    const void* indices) const {
        std::memcpy(min_x + i, &left, sizeof(Ints));
        std::memcpy(max_x + i, &right, sizeof(Ints));
        std::memcpy(min_y + i, &lower, sizeof(Ints));
        std::memcpy(max_y + i, &upper, sizeof(Ints));
        std::memcpy(index + i, indices, sizeof(Ints));
    }
};

// The least width of all boxes that it is given; 2^31 counts as negative.
template <class Lanes>
class Narrowest {
public:
    using Ints = typename Lanes::Ints;

    [[gnu::always_inline]] void operator()(Ints left, Ints right) {
        using Unsigned [[gnu::vector_size(sizeof(Ints))]] = std::uint32_t;
        const auto widths = reinterpret_cast<Ints>(reinterpret_cast<Unsigned>(right) -
                                                   reinterpret_cast<Unsigned>(left));
        least_ = widths < least_ ? widths : least_;
    }
    [[gnu::always_inline]] std::int32_t of_all() const {
        std::int32_t least = least_[0];
        for (unsigned i = 1; i < Lanes::INTS; ++i) least = std::min<std::int32_t>(least, least_[i]);
        return least;
    }

private:
    Ints least_ = std::numeric_limits<std::int32_t>::max() - Ints{};
};

constexpr unsigned FETCH_AHEAD = 16;      // boxes, where a processor does not look that far itself
constexpr unsigned FETCH_FROM = 1 << 15;  // boxes: as many as its second cache cannot hold
constexpr unsigned FILL_ROWS_SLACK = FETCH_AHEAD + 8;  // places that are read beyond the last

template <class Lanes, bool AHEAD, class Box>
[[gnu::always_inline]] inline std::int32_t rows_of(const Box* boxes, const std::uint32_t* order,
                                                   unsigned count, const RowArrays& arrays) {
    using Ints = typename Lanes::Ints;
    const RowArrays rows = arrays;  // a copy, or each vector that is written might have changed it
    const Ints visitor = VISITOR - Ints{};
    Narrowest<Lanes> narrowest;
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
        narrowest(box.min_x, box.max_x);
        rows.put(i, box.min_x, box.max_x, entries < 0 ? visitor : box.min_y, box.max_y, which);
    }
    return narrowest.of_all();
}

// Fetches the boxes that order[0 .. count) names, with AS_VISITOR or without.  What the slack names
// must be boxes, too; up to 7 rows more are written.  Returns the least width of a box, or less.
// O(count).
template <class Lanes>
std::int32_t fill_rows(const BoxList& list, const std::uint32_t* order, unsigned count,
                       const RowArrays& rows) {
    return list.packed               ? rows_of<Lanes, false>(list.packed, order, count, rows)
           : list.entries            ? rows_of<Lanes, false>(list.entries, order, count, rows)
           : list.count < FETCH_FROM ? rows_of<Lanes, false>(list.boxes, order, count, rows)
                                     : rows_of<Lanes, true>(list.boxes, order, count, rows);
}

}  // namespace collision
