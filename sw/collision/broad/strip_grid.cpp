// strip_grid.cpp - see strip_grid.h
#include "collision/broad/strip_grid.h"

#include "collision/broad/places.h"
#include "collision/broad/radix_sort.h"

namespace collision {

bool StripGrid::sort(const BoxList& list, const GridParts& parts) {
    ends_.clear();
    if (!cells_.count(*kernels_, list, parts)) return false;
    std::vector<std::uint32_t>& counts = cells_.counts();
    if (!make_places(counts)) return false;

    list_ = list;
    buckets_ = parts.buckets;
    along_y_ = false;
    const unsigned entries = cells_.entries();
    if (order_.size() < entries + FILL_ROWS_SLACK)
        order_.resize(entries + entries / 8 + FILL_ROWS_SLACK);
    std::uint32_t *order = order_.data(), *places = counts.data();
    cells_.deal(
        list, [=](unsigned i, std::uint32_t cell) { order[places[cell]++] = i; },
        [=](unsigned i, std::uint32_t cell) { order[places[cell]++] = i | AS_VISITOR; });
    std::fill_n(order + entries, FILL_ROWS_SLACK, 0u);
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
    const std::int32_t narrowest =
        kernels_->fill_rows(list_, order_.data() + start, count, store_.arrays(count));
    StripRows rows = store_.rows(count, buckets_, narrowest);
    if (along_y_) {
        std::swap(rows.min_x, rows.min_y);
        std::swap(rows.max_x, rows.max_y);
        rows.narrowest = 0;
    }
    return rows;
}

std::size_t StripGrid::bytes() const {
    return cells_.bytes() + 8 * (keys_.capacity() + spare_.capacity()) +
           4 * (order_.capacity() + ends_.capacity()) + store_.bytes();
}

}  // namespace collision
