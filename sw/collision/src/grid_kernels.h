// grid_kernels.h - the inner loops of the grid of strips: boxes to cells, and to sorted arrays.
#pragma once

#include <algorithm>
#include <cstring>

#include "collision/detail/strip_grid.h"
#include "lanes.h"

namespace collision::detail {

// The distance of positions from `first`, those outside first .. last moved to the nearer end.
template <class Ints>
[[gnu::always_inline]] inline auto offset_in(std::int32_t first, std::int32_t last, Ints at) {
    using Unsigned [[gnu::vector_size(sizeof(Ints))]] = std::uint32_t;
    const Ints least = first - Ints{}, most = last - Ints{};
    at = at > least ? at : least;
    at = at < most ? at : most;
    return reinterpret_cast<Unsigned>(at) - reinterpret_cast<Unsigned>(least);
}

// A visitor counts as beginning below all boxes that are at home in its strip.  So its cell here is
// in the lowest strip, whatever its min.y.
template <class Lanes, bool ENTRIES>
[[gnu::always_inline]] inline void locate_all(const BoxList& list, const StripScale& strips,
                                              const Buckets& buckets, std::uint32_t* cells,
                                              std::uint32_t* above) {
    const BoxList from = list;  // copies: the compiler must assume that stores change the originals
    const StripScale strip_of = strips;
    const Buckets to = buckets;
    const auto vector = [=](unsigned i, auto index) __attribute__((always_inline)) {
        auto box =
            lanes::edges_of<Lanes>([=](unsigned k) __attribute__((always_inline))->const Aabb& {
                if constexpr (ENTRIES) return from.boxes[from.entries[index(k)] & ~VISITOR_BIT];
                return from.boxes[index(k)];
            });
        const auto home = strip_of(offset_in(strip_of.bottom, strip_of.top, box.min_y));
        const auto more = strip_of(offset_in(strip_of.bottom, strip_of.top, box.max_y)) - home;
        const auto cell = home * to.count + (offset_in(to.left, to.right, box.min_x) >> to.shift);
        std::memcpy(cells + i, &cell, sizeof cell);
        std::memcpy(above + i, &more, sizeof more);
    };
    unsigned i = 0;
    for (; i + Lanes::INTS <= from.count; i += Lanes::INTS)
        vector(
            i, [i](unsigned k) __attribute__((always_inline)) { return i + k; });
    const unsigned last = from.count - 1;  // repeated to fill the last vector
    if (i < from.count) vector(i, [i, last](unsigned k) { return std::min(i + k, last); });
}

template <class Lanes>
void locate(const BoxList& list, const StripScale& strips, const Buckets& buckets,
            std::uint32_t* cells, std::uint32_t* above) {
    return list.entries ? locate_all<Lanes, true>(list, strips, buckets, cells, above)
                        : locate_all<Lanes, false>(list, strips, buckets, cells, above);
}

template <class Lanes>
void gather(const Aabb* boxes, const std::uint32_t* entries, unsigned count,
            const EdgeArrays& arrays) {
    using Ints = typename Lanes::Ints;
    const EdgeArrays to = arrays;  // a copy: stores might change the original
    for (unsigned i = 0; i < count; i += Lanes::INTS) {
        const auto named = lanes::load<Ints>(entries + i);
        const Ints bare = named & static_cast<std::int32_t>(~VISITOR_BIT);
        std::uint32_t index[Lanes::INTS];
        std::memcpy(index, &bare, sizeof bare);
        const auto box =
            lanes::edges_of<Lanes>([&](unsigned k) __attribute__((always_inline))->const Aabb& {
                return boxes[index[k]];
            });
        const Ints min_y = named < 0 ? VISITOR_MIN_Y - Ints{} : box.min_y;
        std::memcpy(to.min_x + i, &box.min_x, sizeof(Ints));
        std::memcpy(to.max_x + i, &box.max_x, sizeof(Ints));
        std::memcpy(to.min_y + i, &min_y, sizeof(Ints));
        std::memcpy(to.max_y + i, &box.max_y, sizeof(Ints));
        std::memcpy(to.index + i, index, sizeof(Ints));
    }
}

}  // namespace collision::detail
