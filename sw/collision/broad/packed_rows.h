// packed_rows.h - kernels of Strips: packed entries to the buckets where they begin, and in their
// order to an array an edge.
#pragma once

#include "collision/broad/box_cells.h"
#include "collision/broad/fill_rows.h"

namespace collision {

constexpr unsigned PACKED_SLACK = 8;  // entries that are read and rows that are written beyond

// Writes the bucket of each entry, and up to 7 numbers more, for which as many entries more are
// read.  O(count), without a branch.
template <class Lanes>
void packed_buckets(const PackedEntry* entries, unsigned count, const BucketParts& parts,
                    std::uint32_t* buckets) {
    const BucketParts to = parts;
    for (unsigned i = 0; i < count; i += Lanes::INTS) {
        const auto raw =
            turned<Lanes>([=](unsigned k) __attribute__((always_inline))->const PackedEntry& {
                return entries[i + k];
            });
        const auto bucket = offsets_in(to.first, to.last, raw.min_x) >> to.shift;
        std::memcpy(buckets + i, &bucket, sizeof bucket);
    }
}

// Returns the least width of a box, or less if the slack has one.  O(count).
template <class Lanes>
std::int32_t packed_rows(const PackedEntry* entries, unsigned count, const RowArrays& arrays) {
    const RowArrays rows = arrays;  // a copy, or each vector that is written might have changed it
    Narrowest<Lanes> narrowest;
    for (unsigned i = 0; i < count; i += Lanes::INTS) {
        const auto box =
            columns<Lanes>([=](unsigned k) __attribute__((always_inline))->const PackedEntry& {
                return entries[i + k];
            });
        narrowest(box.min_x, box.max_x);
        rows.put(i, box.min_x, box.max_x, box.min_y, box.max_y, &box.index);
    }
    return narrowest.of_all();
}

}  // namespace collision
