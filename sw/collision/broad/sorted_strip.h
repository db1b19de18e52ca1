// sorted_strip.h - the boxes of one strip, sorted by where they begin on the x axis.
#pragma once

#include <cstdint>
#include <vector>

#include "collision/broad/strip_rows.h"
#include "collision/polygon.h"

namespace collision {

// A box with its index, so that what is tested together lies together.
struct Entry {
    Aabb box;  // min.y may be VISITOR
    std::uint32_t index;
};

class SortedStrip {
public:
    // Sorts `count` > 0 entries by min.x into as many buckets of equal width between `left` and
    // `right`, where most of them should lie; where the buckets fill unevenly, exactly.  The rows
    // are valid until the next call.  O(count).
    StripRows sort(const Entry* entries, unsigned count, std::int32_t left, std::int32_t right);

    std::size_t bytes() const;  // of memory in use

private:
    StripRows arrays(unsigned count);
    bool into_buckets(const Entry* entries, unsigned count, std::int32_t left, std::int32_t right);
    void exactly(const Entry* entries, unsigned count);
    void put(unsigned place, const Entry& entry);

    std::int32_t* edge(unsigned which) { return edges_.data() + which * stride_; }

    std::size_t stride_ = 0;           // from one array to the next
    std::vector<std::int32_t> edges_;  // min_x, max_x, min_y, max_y
    std::vector<std::uint32_t> index_, end_;
    std::vector<std::uint32_t> places_;  // of the next entry of each bucket
    std::vector<std::uint64_t> keys_, spare_;
};

}  // namespace collision
