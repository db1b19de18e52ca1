// strip_grid.cpp - see strip_grid.h
#include "collision/broad/strip_grid.h"

#include "collision/broad/radix_sort.h"

namespace collision {
namespace {

// Arrays a multiple of 4 KiB apart push each other out of the cache: these never are.
constexpr std::size_t PAGE = 1024, SKEW = 208;  // elements

// Boxes spread at random with m others in their bucket on average: the sum of the squares of the
// numbers of boxes is then m + 1 times the number of boxes.  A few vectors of others cost less than
// to cut the world again.
constexpr std::uint64_t UNEVEN = 32;

}  // namespace

bool StripGrid::sort(const BoxList& list, const GridParts& parts) {
    ends_.clear();
    if (!cells_.count(*kernels_, list, parts)) return false;
    std::vector<std::uint32_t>& counts = cells_.counts();
    std::uint32_t place = 0;
    std::uint64_t squares = 0;
    for (std::uint32_t& in_bucket : counts) {
        const std::uint32_t count = in_bucket;
        squares += std::uint64_t{count} * count;
        in_bucket = place;  // where the bucket begins
        place += count;
    }
    if (squares > UNEVEN * list.count) return false;

    list_ = list;
    buckets_ = parts.buckets;
    along_y_ = false;
    if (order_.size() < place + FILL_ROWS_SLACK) order_.resize(place + place / 8 + FILL_ROWS_SLACK);
    std::uint32_t *order = order_.data(), *places = counts.data();
    cells_.deal(
        list, [=](unsigned i, std::uint32_t cell) { order[places[cell]++] = i; },
        [=](unsigned i, std::uint32_t cell) { order[places[cell]++] = i | AS_VISITOR; });
    std::fill_n(order + place, FILL_ROWS_SLACK, 0u);
    // Now each place is where the next bucket begins.
    for (unsigned strip = 1; strip <= parts.strips.count; ++strip)
        ends_.push_back(places[strip * parts.buckets.count - 1]);
    return true;
}

void StripGrid::sort_exactly(const BoxList& list) {
    keys_.resize(list.count);
    for (unsigned i = 0; i < list.count; ++i) keys_[i] = sort_key(list.box(i).min.x, i);
    radix_sort(keys_, spare_);
    arrange(list, keys_, false);
}

void StripGrid::arrange(const BoxList& list, const std::vector<std::uint64_t>& keys, bool along_y) {
    list_ = list;
    along_y_ = along_y;
    const auto at = [along_y](const Aabb& box) { return along_y ? box.min.y : box.min.x; };
    buckets_ = {at(list.box(index_of(keys.front()))), at(list.box(index_of(keys.back()))), 2};
    buckets_.shift = 0;
    order_.resize(keys.size() + FILL_ROWS_SLACK);
    for (std::size_t i = 0; i < keys.size(); ++i) order_[i] = index_of(keys[i]);
    std::fill_n(order_.data() + keys.size(), FILL_ROWS_SLACK, 0u);
    ends_.assign(1, static_cast<std::uint32_t>(keys.size()));
}

StripRows StripGrid::rows(unsigned strip) {
    const std::uint32_t start = strip == 0 ? 0 : ends_[strip - 1];
    const std::uint32_t count = ends_[strip] - start;
    if (index_.size() < count + StripRows::PADDING) {
        stride_ = (count + count / 8 + StripRows::PADDING + PAGE - 1) / PAGE * PAGE + SKEW;
        edges_.resize(4 * stride_);
        index_.resize(stride_);
    }
    std::int32_t *min_x = edges_.data(), *max_x = min_x + stride_;
    std::int32_t *min_y = max_x + stride_, *max_y = min_y + stride_;
    kernels_->fill_rows(list_, order_.data() + start, count,
                        {min_x, max_x, min_y, max_y, index_.data()});
    for (std::int32_t* edge : {min_x, max_x, min_y, max_y})
        std::fill_n(edge + count, StripRows::PADDING, std::numeric_limits<std::int32_t>::max());
    if (along_y_) {
        std::swap(min_x, min_y);
        std::swap(max_x, max_y);
    }
    return {min_x,          max_x,         min_y,
            max_y,          index_.data(), count,
            buckets_.first, buckets_.last, (std::uint32_t{1} << buckets_.shift) - 1};
}

std::size_t StripGrid::bytes() const {
    return cells_.bytes() + 8 * (keys_.capacity() + spare_.capacity()) +
           4 * (order_.capacity() + ends_.capacity() + edges_.capacity() + index_.capacity());
}

}  // namespace collision
