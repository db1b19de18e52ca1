// strip_grid.cpp - see strip_grid.h
#include "collision/broad/strip_grid.h"

#include "collision/broad/radix_sort.h"

namespace collision {
namespace {

// Arrays a multiple of 4 KiB apart push each other out of the cache: these never are.
constexpr std::size_t PAGE = 1024, SKEW = 208;  // elements

// Boxes spread at random over as many buckets share theirs with one other on average: the sum of
// the squares of the numbers of boxes is then twice the number of boxes.
constexpr std::uint64_t UNEVEN = 12;
constexpr std::uint64_t MOST_COPIES = 2;  // of a box, on average

}  // namespace

void StripGrid::reserve(std::size_t places) {
    if (index_.size() >= places) return;
    stride_ = (places + places / 8 + PAGE - 1) / PAGE * PAGE + SKEW;
    edges_.resize(4 * stride_);
    sorted_.resize(stride_);
    index_.resize(stride_);
}

void StripGrid::put(std::size_t place, const Aabb& box, std::int32_t min_y, std::uint32_t index) {
    sorted_[place] = {{box.min.x, min_y}, box.max};
    index_[place] = index;
}

void StripGrid::end_strip(std::size_t start, std::size_t end, const BucketOf& bucket_of) {
    for (std::size_t i = end; i < end + StripRows::PADDING; ++i) {
        constexpr std::int32_t MOST = std::numeric_limits<std::int32_t>::max();
        put(i, {{MOST, MOST}, {MOST, MOST}}, MOST, 0);
    }
    std::int32_t *min_x = edge(0), *max_x = edge(1), *min_y = edge(2), *max_y = edge(3);
    for (std::size_t i = start; i < end + StripRows::PADDING; ++i) {
        const auto& [min, max] = sorted_[i];
        min_x[i] = min.x;
        max_x[i] = max.x;
        min_y[i] = min.y;
        max_y[i] = max.y;
    }
    strips_.push_back({edge(0) + start, edge(1) + start, edge(2) + start, edge(3) + start,
                       index_.data() + start, static_cast<unsigned>(end - start), bucket_of.left,
                       bucket_of.right, (std::uint32_t{1} << bucket_of.shift) - 1});
}

template <class Source, class Strip>
bool StripGrid::sort(const Source& source, unsigned count, const Strip& strip_of,
                     const BucketOf& bucket_of) {
    strips_.clear();
    const unsigned buckets = bucket_of.count;
    places_.assign(std::size_t{buckets} * strip_of.count, 0);
    std::uint32_t* places = places_.data();
    std::uint64_t copies = 0;
    for (unsigned i = 0; i < count; ++i) {
        const Aabb& box = source.box(i);
        const std::uint32_t first = strip_of(box.min.y), last = strip_of(box.max.y);
        std::uint32_t* in_strip = places + first * buckets + bucket_of(box.min.x);
        ++*in_strip;
        for (std::uint32_t strip = first; strip < last; ++strip) ++*(in_strip += buckets);
        copies += last - first;
    }
    if (copies > MOST_COPIES * count) return false;

    std::uint32_t place = 0;
    std::uint64_t squares = 0;
    for (unsigned strip = 0; strip < strip_of.count; ++strip) {
        for (unsigned bucket = 0; bucket < buckets; ++bucket, ++places) {
            const std::uint32_t in_bucket = *places;
            squares += std::uint64_t{in_bucket} * in_bucket;
            *places = place;
            place += in_bucket;
        }
        place += StripRows::PADDING;
    }
    if (squares > UNEVEN * count) return false;

    reserve(place);
    places = places_.data();
    for (unsigned i = 0; i < count; ++i) {
        const Aabb& box = source.box(i);
        const std::uint32_t index = source.index(i);
        const std::uint32_t first = strip_of(box.min.y), last = strip_of(box.max.y);
        std::uint32_t* in_strip = places + first * buckets + bucket_of(box.min.x);
        put((*in_strip)++, box, box.min.y, index);
        for (std::uint32_t strip = first; strip < last; ++strip)
            put((*(in_strip += buckets))++, box, VISITOR, index);
    }
    // Now each place is where the next bucket begins.
    std::size_t start = 0;
    for (unsigned strip = 0; strip < strip_of.count; ++strip) {
        const std::size_t end = places_[(strip + 1) * std::size_t{buckets} - 1];
        end_strip(start, end, bucket_of);
        start = end + StripRows::PADDING;
    }
    return true;
}

template bool StripGrid::sort(const FromBoxes&, unsigned, const StripOf&, const BucketOf&);
template bool StripGrid::sort(const FromEntries&, unsigned, const StripOf&, const BucketOf&);
template bool StripGrid::sort(const FromEntries&, unsigned, const OneStrip&, const BucketOf&);

void StripGrid::sort_exactly(const Entry* entries, unsigned count) {
    keys_.resize(count);
    for (unsigned i = 0; i < count; ++i) keys_[i] = sort_key(entries[i].box.min.x, i);
    radix_sort(keys_, spare_);
    arrange(FromEntries{entries}, keys_);
}

template <class Source>
void StripGrid::arrange(const Source& source, const std::vector<std::uint64_t>& keys) {
    strips_.clear();
    reserve(keys.size() + StripRows::PADDING);
    std::size_t place = 0;
    for (const std::uint64_t key : keys) {
        const Aabb& box = source.box(index_of(key));
        put(place++, box, box.min.y, source.index(index_of(key)));
    }
    BucketOf units = {sorted_[0].min.x, sorted_[place - 1].min.x, 1};
    units.shift = 0;
    end_strip(0, place, units);
}

template void StripGrid::arrange(const FromAxis&, const std::vector<std::uint64_t>&);

std::size_t StripGrid::bytes() const {
    return 4 * (edges_.capacity() + index_.capacity() + places_.capacity()) +
           8 * (keys_.capacity() + spare_.capacity()) + sizeof(Aabb) * sorted_.capacity() +
           strips_.capacity() * sizeof(StripRows);
}

}  // namespace collision
