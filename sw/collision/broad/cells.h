// cells.h - boxes dealt out to the cells of a grid: counted first, then named one by one.
#pragma once

#include <cstdint>
#include <vector>

#include "collision/broad/kernels.h"

namespace collision {

// A box is an entry of the cell in which it begins, and as a visitor of each cell above that up to
// the strip in which it ends.
class Cells {
public:
    // Counts the entries of each cell.  False, and no counts, if there are more than MOST_COPIES
    // visitors a box: the cost is then out of proportion.  O(count + cells).
    bool count(const Kernels& kernels, const BoxList& list, const GridParts& parts);

    static constexpr unsigned MOST_COPIES = 2;

    // Valid after count().  The counts may be turned into what the caller likes.
    std::vector<std::uint32_t>& counts() { return counts_; }
    unsigned entries() const { return entries_; }  // of all cells

    // Calls put(box, cell) for each box in order, then put_visitor(box, cell) for each visitor.
    template <class Put, class PutVisitor>
    [[gnu::always_inline]] void deal(const BoxList& list, Put put, PutVisitor put_visitor) const {
        const std::uint32_t* cells = cells_.data();
        const unsigned count = list.count;  // a copy, or what is put might have changed it
        for (unsigned i = 0; i < count; ++i) put(i, cells[i]);
        for (unsigned k = 0; k < tall_count_; ++k) {
            const unsigned i = tall_[k];
            std::uint32_t cell = cells[i];
            for (unsigned more = above_[k]; more > 0; --more)
                put_visitor(i, cell += parts_.buckets.count);
        }
    }

    std::size_t bytes() const {
        return 4 * (cells_.capacity() + tall_.capacity() + above_.capacity() + counts_.capacity());
    }

private:
    unsigned strips_above(const Aabb& box) const {
        return parts_.strips(box.max.y) - parts_.strips(box.min.y);
    }

    GridParts parts_ = {{0, 0, 1}, {0, 0, 1}};
    std::vector<std::uint32_t> cells_, counts_;
    std::vector<std::uint32_t> tall_, above_;  // boxes, and in how many strips each is a visitor
    unsigned tall_count_ = 0, entries_ = 0;
};

}  // namespace collision
