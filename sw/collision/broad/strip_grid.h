// strip_grid.h - the boxes of a few strips, strip by strip, in the order of where they begin on the
// x axis.
#pragma once

#include <cstdint>
#include <vector>

#include "collision/broad/cells.h"

namespace collision {

class StripGrid {
public:
    explicit StripGrid(const Kernels& kernels) : kernels_{&kernels} {}

    // Puts each box into all strips that it reaches, there into the bucket of min.x.  False, and no
    // strips, if most boxes share their bucket with many others or if they have too many copies:
    // the cost is then out of proportion.  O(count + cells).
    bool sort(const BoxList& list, const GridParts& parts);

    // One strip, in the exact order of min.x whatever they share.  O(count).
    void sort_exactly(const BoxList& list);

    // One strip of what the sort keys stand for, which are in order; the axes exchanged if
    // `along_y`.  At least one.  O(keys).
    void arrange(const BoxList& list, const std::vector<std::uint64_t>& keys, bool along_y);

    // Valid until the next call of any of these.
    const std::vector<StripRows>& strips() const { return strips_; }

    std::size_t bytes() const;  // of memory in use

private:
    void reserve(std::size_t places);
    void end_strip(const BoxList& list, std::size_t start, std::size_t end,
                   const BucketParts& buckets);

    RowArrays arrays();

    const Kernels* kernels_;
    Cells cells_;
    std::size_t stride_ = 0;  // from one array to the next
    std::vector<std::int32_t> edges_;
    std::vector<std::uint32_t> index_;
    std::vector<StripRows> strips_;
    std::vector<std::uint64_t> keys_, spare_;
};

}  // namespace collision
