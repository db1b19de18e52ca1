// columns.h - boxes turned by a quarter: a vector of each edge.
#pragma once

#include <type_traits>

#include "collision/broad/box_list.h"
#include "collision/broad/lanes.h"
#include "collision/four.h"

namespace collision {

template <class Lanes>
struct Columns {
    typename Lanes::Ints min_x, min_y, max_x, max_y;
};

template <class Lanes>
struct PackedColumns : Columns<Lanes> {
    typename Lanes::Ints index;
};

// Four numbers a box.  Four or eight loads, then shuffles within 16 bytes, the cheap ones.
template <class Lanes, class Box>
[[gnu::always_inline]] inline Columns<Lanes> turned(const Box& box) {
    using Ints = typename Lanes::Ints;
    static_assert(Lanes::INTS == 4 || Lanes::INTS == 8, "vectors of 16 or 32 bytes");
    if constexpr (Lanes::INTS == 4) {
        const Ints a = four(box(0)), b = four(box(1)), c = four(box(2)), d = four(box(3));
        const Ints min_ab = __builtin_shufflevector(a, b, 0, 4, 1, 5);
        const Ints min_cd = __builtin_shufflevector(c, d, 0, 4, 1, 5);
        const Ints max_ab = __builtin_shufflevector(a, b, 2, 6, 3, 7);
        const Ints max_cd = __builtin_shufflevector(c, d, 2, 6, 3, 7);
        return {__builtin_shufflevector(min_ab, min_cd, 0, 1, 4, 5),
                __builtin_shufflevector(min_ab, min_cd, 2, 3, 6, 7),
                __builtin_shufflevector(max_ab, max_cd, 0, 1, 4, 5),
                __builtin_shufflevector(max_ab, max_cd, 2, 3, 6, 7)};
    } else {
        const auto both = [&box](unsigned i) __attribute__((always_inline))->Ints {
            return __builtin_shufflevector(four(box(i)), four(box(i + 4)), 0, 1, 2, 3, 4, 5, 6, 7);
        };
        const Ints a = both(0), b = both(1), c = both(2), d = both(3);
        const Ints min_ab = __builtin_shufflevector(a, b, 0, 8, 1, 9, 4, 12, 5, 13);
        const Ints min_cd = __builtin_shufflevector(c, d, 0, 8, 1, 9, 4, 12, 5, 13);
        const Ints max_ab = __builtin_shufflevector(a, b, 2, 10, 3, 11, 6, 14, 7, 15);
        const Ints max_cd = __builtin_shufflevector(c, d, 2, 10, 3, 11, 6, 14, 7, 15);
        return {__builtin_shufflevector(min_ab, min_cd, 0, 1, 8, 9, 4, 5, 12, 13),
                __builtin_shufflevector(min_ab, min_cd, 2, 3, 10, 11, 6, 7, 14, 15),
                __builtin_shufflevector(max_ab, max_cd, 0, 1, 8, 9, 4, 5, 12, 13),
                __builtin_shufflevector(max_ab, max_cd, 2, 3, 10, 11, 6, 7, 14, 15)};
    }
}

// From four columns of packed entries as they lie in memory.
template <class Lanes>
[[gnu::always_inline]] inline PackedColumns<Lanes> unpacked(const Columns<Lanes>& raw) {
    using Ints = typename Lanes::Ints;
    const Ints visitor = VISITOR - Ints{}, sides = raw.max_x, index = raw.max_y;
    return {{raw.min_x, index < 0 ? visitor : raw.min_y, raw.min_x + (sides & 0xffff),
             raw.min_y + (sides >> 16 & 0xffff)},
            index & ~visitor};
}

// Lane i is box(i): an Aabb, an Entry, or a PackedEntry, which gives PackedColumns.
template <class Lanes, class At>
[[gnu::always_inline]] inline auto columns(const At& box) {
    using Box = std::decay_t<decltype(box(0))>;
    if constexpr (std::is_same_v<Box, PackedEntry>)
        return unpacked<Lanes>(turned<Lanes>(box));
    else if constexpr (std::is_same_v<Box, Entry>)
        return turned<Lanes>([&box](unsigned i) __attribute__((always_inline))->const Aabb& {
            return box(i).box;
        });
    else
        return turned<Lanes>(box);
}

}  // namespace collision
