// row_store.h - the memory behind the rows of a strip.
#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>
#include <vector>

#include "collision/broad/grid_parts.h"
#include "collision/broad/strip_rows.h"

namespace collision {

// arrays(), which a kernel fills, then rows().
class RowStore {
public:
    // Room for `count` rows and PADDING; in place of what was there.
    RowArrays arrays(unsigned count) {
        if (index_.size() < count + StripRows::PADDING) {
            stride_ = (count + count / 8 + StripRows::PADDING + PAGE - 1) / PAGE * PAGE + SKEW;
            edges_.resize(4 * stride_);
            index_.resize(stride_);
        }
        std::int32_t* edges = edges_.data();
        return {edges, edges + stride_, edges + 2 * stride_, edges + 3 * stride_, index_.data()};
    }

    // Valid until the next arrays().
    StripRows rows(unsigned count, const BucketParts& buckets, std::int32_t narrowest) {
        constexpr std::int32_t LEAST = std::numeric_limits<std::int32_t>::min();
        constexpr std::int32_t MOST = std::numeric_limits<std::int32_t>::max();
        std::int32_t *min_x = edges_.data(), *max_x = min_x + stride_;
        std::int32_t *min_y = max_x + stride_, *max_y = min_y + stride_;
        for (std::int32_t* edge : {min_x, min_y})
            std::fill_n(edge + count, StripRows::PADDING, MOST);
        for (std::int32_t* edge : {max_x, max_y})
            std::fill_n(edge + count, StripRows::PADDING, LEAST);
        const std::uint32_t mask = (std::uint32_t{1} << buckets.shift) - 1;
        return {min_x, max_x,         min_y,        max_y, index_.data(),
                count, buckets.first, buckets.last, mask,  narrowest};
    }

    std::size_t bytes() const {  // of memory in use
        return 4 * (edges_.capacity() + index_.capacity());
    }

private:
    // Arrays a multiple of 4 KiB apart push each other out of the cache: these never are.
    static constexpr std::size_t PAGE = 1024, SKEW = 208;  // elements

    std::size_t stride_ = 0;  // from one array of edges to the next
    std::vector<std::int32_t> edges_;
    std::vector<std::uint32_t> index_;
};

}  // namespace collision
