// sorted_boxes.h - boxes in the order in which they begin along x, as the sweep reads them.
//
// One array for each edge, so that a vector register holds the same edge of several boxes.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "collision/detail/kernels.h"
#include "collision/polygon.h"

namespace collision::detail {

// An index of a box, with this bit where the box is a visitor: it lies in a strip (strip_grid.h)
// but begins in one below.
constexpr std::uint32_t VISITOR_BIT = 0x80000000;

// Elements that a vector may read or write beyond the end of an array.
constexpr unsigned SLACK = 8;

// In place of a visitor's min.y.  Below every coordinate of the grid.
constexpr std::int32_t VISITOR_MIN_Y = std::numeric_limits<std::int32_t>::min();

// Each array has `count` boxes, then PADDING boxes that overlap nothing, so that a vector may be
// read beyond the end.
//
// They are sorted exactly, or only into buckets of min_x: the buckets are mask + 1 units wide (a
// power of two) and the first begins at `left`; positions left of that belong to the first bucket,
// positions right of `right` to the last.
struct SortedBoxes {
    static constexpr unsigned PADDING = 32;

    const std::int32_t *min_x, *max_x, *min_y, *max_y;
    const std::uint32_t* index;  // of each box in the caller's array
    unsigned count;
    std::int32_t left, right;
    std::uint32_t mask;
};

// How the min_x of boxes are divided into buckets.
struct Buckets {
    std::int32_t left, right;
    unsigned shift, count;

    // At most `wanted` buckets for left .. right, and more than half as many if there are as many
    // units.  left <= right; wanted > 0.
    Buckets(std::int32_t left, std::int32_t right, unsigned wanted);

    // Of one unit each, for boxes that are sorted exactly.
    static Buckets of_one_unit(std::int32_t left, std::int32_t right) {
        Buckets buckets(left, right, 2);
        buckets.shift = 0;
        return buckets;
    }
};

// The memory to which SortedBoxes points, kept from call to call.
class SortedBoxStore {
public:
    // Copies the boxes of entries[0 .. count), visitors as such, in this order, which is that of
    // `buckets`.  SLACK entries more are read, and must name boxes.  Valid until the next call.
    // O(count).
    SortedBoxes fill(const Kernels& kernels, const Aabb* boxes, const std::uint32_t* entries,
                     unsigned count, const Buckets& buckets);

    std::size_t bytes() const { return 4 * (edges_.capacity() + index_.capacity()); }

private:
    std::size_t stride_ = 0;  // elements from one array of edges to the next
    std::vector<std::int32_t> edges_;
    std::vector<std::uint32_t> index_;
};

}  // namespace collision::detail
