// strip_grid.h - the boxes of a few strips, strip by strip, in the order of where they begin on the
// x axis.
#pragma once

#include <cstdint>
#include <vector>

#include "collision/broad/cells.h"
#include "collision/broad/row_store.h"

namespace collision {

// First one of the three that sort, then rows() for each strip.  The boxes must stay where they are
// meanwhile.
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

    unsigned strips() const { return static_cast<unsigned>(ends_.size()); }

    // The boxes of a strip, fetched into the place of those of the strip before, so that they are
    // still in the cache when they are swept.  O(boxes in the strip).
    StripRows rows(unsigned strip);

    std::size_t bytes() const;  // of memory in use

private:
    const Kernels* kernels_;
    Cells cells_;
    std::vector<std::uint64_t> keys_, spare_;

    // What was sorted.
    BoxList list_{};
    BucketParts buckets_ = {0, 0, 1};
    bool along_y_ = false;
    std::vector<std::uint32_t> order_;  // of boxes, strip by strip, and some slack
    std::vector<std::uint32_t> ends_;   // of the strips

    RowStore store_;  // for one strip
};

}  // namespace collision
