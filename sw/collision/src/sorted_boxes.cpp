// sorted_boxes.cpp - see sorted_boxes.h
#include "collision/detail/sorted_boxes.h"

#include <algorithm>

namespace collision::detail {

namespace {

// Arrays that are a multiple of 4 KiB apart evict each other from the cache; these never are.
constexpr std::size_t PAGE = 1024, SKEW = 208;  // elements

}  // namespace

Buckets::Buckets(std::int32_t left_most, std::int32_t right_most, unsigned wanted)
    : left{left_most}, right{wanted > 1 ? right_most : left_most}, shift{0} {
    const std::uint32_t span = static_cast<std::uint32_t>(right) - static_cast<std::uint32_t>(left);
    while (span >> shift >= wanted) ++shift;
    count = (span >> shift) + 1;
}

SortedBoxes SortedBoxStore::fill(const Kernels& kernels, const Aabb* boxes,
                                 const std::uint32_t* entries, unsigned count,
                                 const Buckets& buckets) {
    constexpr unsigned PADDING = SortedBoxes::PADDING;
    if (index_.size() < count + PADDING) {
        stride_ = (count + count / 8 + PADDING + PAGE - 1) / PAGE * PAGE + SKEW;
        edges_.resize(4 * stride_);
        index_.resize(stride_);
    }
    std::int32_t *const min_x = edges_.data(), *const max_x = min_x + stride_;
    std::int32_t *const min_y = max_x + stride_, *const max_y = min_y + stride_;
    kernels.gather(boxes, entries, count, {min_x, max_x, min_y, max_y, index_.data()});
    constexpr std::int32_t LEAST = std::numeric_limits<std::int32_t>::min();
    constexpr std::int32_t MOST = std::numeric_limits<std::int32_t>::max();
    for (std::int32_t* edge : {min_x, min_y}) std::fill_n(edge + count, PADDING, MOST);
    for (std::int32_t* edge : {max_x, max_y}) std::fill_n(edge + count, PADDING, LEAST);
    return {min_x,        max_x,         min_y,
            max_y,        index_.data(), count,
            buckets.left, buckets.right, (std::uint32_t{1} << buckets.shift) - 1};
}

}  // namespace collision::detail
