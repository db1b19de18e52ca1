// strip_grid.cpp - see strip_grid.h
#include "collision/broad/strip_grid.h"

#include "collision/broad/radix_sort.h"

namespace collision {
namespace {

// Arrays a multiple of 4 KiB apart push each other out of the cache: these never are.
constexpr std::size_t PAGE = 1024, SKEW = 208;  // elements

// Boxes spread at random with m others in their bucket on average: the sum of the squares of the
// numbers of boxes is then m + 1 times the number of boxes.
constexpr std::uint64_t UNEVEN = 12;

}  // namespace

void StripGrid::reserve(std::size_t places) {
    strips_.clear();
    if (index_.size() >= places) return;
    stride_ = (places + places / 8 + PAGE - 1) / PAGE * PAGE + SKEW;
    edges_.resize(4 * stride_);
    index_.resize(stride_);
}

RowArrays StripGrid::arrays() {
    std::int32_t* edges = edges_.data();
    return {edges, edges + stride_, edges + 2 * stride_, edges + 3 * stride_, index_.data()};
}

// The order of the boxes is in the index.
void StripGrid::end_strip(const BoxList& list, std::size_t start, std::size_t end,
                          const BucketParts& buckets) {
    const RowArrays rows = arrays();
    std::fill_n(rows.index + end, StripRows::PADDING, 0u);
    kernels_->fill_rows(list, rows, start, end);
    for (std::int32_t* edge : {rows.min_x, rows.max_x, rows.min_y, rows.max_y})
        std::fill_n(edge + end, StripRows::PADDING, std::numeric_limits<std::int32_t>::max());
    strips_.push_back({rows.min_x + start, rows.max_x + start, rows.min_y + start,
                       rows.max_y + start, rows.index + start, static_cast<unsigned>(end - start),
                       buckets.first, buckets.last, (std::uint32_t{1} << buckets.shift) - 1});
}

bool StripGrid::sort(const BoxList& list, const GridParts& parts) {
    if (!cells_.count(*kernels_, list, parts)) return false;
    const unsigned buckets = parts.buckets.count;
    std::uint32_t* places = cells_.counts().data();
    std::uint32_t place = 0;
    std::uint64_t squares = 0;
    for (unsigned strip = 0; strip < parts.strips.count; ++strip) {
        for (unsigned bucket = 0; bucket < buckets; ++bucket) {
            std::uint32_t& in_bucket = places[strip * buckets + bucket];
            const std::uint32_t count = in_bucket;
            squares += std::uint64_t{count} * count;
            in_bucket = place;
            place += count;
        }
        place += StripRows::PADDING;
    }
    if (squares > UNEVEN * list.count) return false;

    reserve(place);
    std::uint32_t* order = index_.data();
    cells_.deal(
        list, [=](unsigned i, std::uint32_t cell) { order[places[cell]++] = i; },
        [=](unsigned i, std::uint32_t cell) { order[places[cell]++] = i | AS_VISITOR; });
    // Now each place is where the next bucket begins.
    std::size_t start = 0;
    for (unsigned strip = 1; strip <= parts.strips.count; ++strip) {
        const std::size_t end = places[strip * buckets - 1];
        end_strip(list, start, end, parts.buckets);
        start = end + StripRows::PADDING;
    }
    return true;
}

void StripGrid::sort_exactly(const BoxList& list) {
    keys_.resize(list.count);
    for (unsigned i = 0; i < list.count; ++i) keys_[i] = sort_key(list.box(i).min.x, i);
    radix_sort(keys_, spare_);
    arrange(list, keys_, false);
}

void StripGrid::arrange(const BoxList& list, const std::vector<std::uint64_t>& keys, bool along_y) {
    reserve(keys.size() + StripRows::PADDING);
    for (std::size_t i = 0; i < keys.size(); ++i) index_[i] = index_of(keys[i]);
    const auto at = [along_y](const Aabb& box) { return along_y ? box.min.y : box.min.x; };
    const std::int32_t first = at(list.box(index_of(keys.front())));
    const std::int32_t last = at(list.box(index_of(keys.back())));
    BucketParts units = {first, last, 2};
    units.shift = 0;
    end_strip(list, 0, keys.size(), units);
    if (!along_y) return;
    StripRows& rows = strips_.back();
    std::swap(rows.min_x, rows.min_y);
    std::swap(rows.max_x, rows.max_y);
}

std::size_t StripGrid::bytes() const {
    return cells_.bytes() + 4 * (edges_.capacity() + index_.capacity()) +
           8 * (keys_.capacity() + spare_.capacity()) + strips_.capacity() * sizeof(StripRows);
}

}  // namespace collision
