// sorted_strip.cpp - see sorted_strip.h
#include "collision/broad/sorted_strip.h"

#include <algorithm>
#include <limits>

#include "collision/broad/radix_sort.h"

namespace collision {
namespace {

// Arrays a multiple of 4 KiB apart push each other out of the cache: these never are.
constexpr std::size_t PAGE = 1024, SKEW = 208;  // elements

// Entries spread at random over as many buckets share them with one other on average, counting
// themselves: the sum of the squares of their numbers is twice the number of entries.
constexpr std::uint64_t UNEVEN = 16;

// The bucket of a position; positions outside belong to the first and the last.
struct Buckets {
    std::int32_t left, right;
    unsigned shift, count;

    Buckets(std::int32_t from, std::int32_t to, unsigned wanted) : left{from}, right{to}, shift{0} {
        const std::uint32_t span = offset(right);
        while (span >> shift >= wanted) ++shift;
        count = (span >> shift) + 1;
    }
    std::uint32_t offset(std::int32_t at) const {
        return static_cast<std::uint32_t>(at) - static_cast<std::uint32_t>(left);
    }
    std::uint32_t operator()(std::int32_t at) const {
        return offset(std::min(std::max(at, left), right)) >> shift;
    }
};

}  // namespace

StripRows SortedStrip::arrays(unsigned count) {
    const std::size_t needed = count + StripRows::PADDING;
    if (index_.size() < needed) {
        stride_ = (needed + needed / 4 + PAGE - 1) / PAGE * PAGE + SKEW;
        edges_.resize(4 * stride_);
        index_.resize(stride_);
        end_.resize(stride_);
    }
    return {edge(0), edge(1), edge(2), edge(3), index_.data(), end_.data(), count};
}

void SortedStrip::put(unsigned place, const Entry& entry) {
    edge(0)[place] = entry.box.min.x;
    edge(1)[place] = entry.box.max.x;
    edge(2)[place] = entry.box.min.y;
    edge(3)[place] = entry.box.max.y;
    index_[place] = entry.index;
}

bool SortedStrip::into_buckets(const Entry* entries, unsigned count, std::int32_t left,
                               std::int32_t right) {
    const Buckets bucket = {left, right, 2 * count};
    places_.assign(bucket.count, 0);
    for (unsigned i = 0; i < count; ++i) ++places_[bucket(entries[i].box.min.x)];
    std::uint32_t place = 0;
    std::uint64_t squares = 0;
    for (std::uint32_t& of_bucket : places_) {
        const std::uint32_t in_bucket = of_bucket;
        squares += std::uint64_t{in_bucket} * in_bucket;
        of_bucket = place;
        place += in_bucket;
    }
    if (squares > UNEVEN * count) return false;
    for (unsigned i = 0; i < count; ++i) put(places_[bucket(entries[i].box.min.x)]++, entries[i]);
    // Now each place is where the next bucket begins.
    for (unsigned i = 0; i < count; ++i) end_[i] = places_[bucket(edge(1)[i])];
    return true;
}

void SortedStrip::exactly(const Entry* entries, unsigned count) {
    keys_.resize(count);
    for (unsigned i = 0; i < count; ++i) keys_[i] = sort_key(entries[i].box.min.x, i);
    radix_sort(keys_, spare_);
    for (unsigned i = 0; i < count; ++i) put(i, entries[index_of(keys_[i])]);
    const std::int32_t* min_x = edge(0);
    for (unsigned i = 0; i < count; ++i) {
        unsigned step = 1;
        while (i + step < count && min_x[i + step] <= edge(1)[i]) step *= 2;
        const auto* last = min_x + std::min(i + step, count);
        end_[i] = static_cast<std::uint32_t>(
            std::upper_bound(min_x + i + step / 2, last, edge(1)[i]) - min_x);
    }
}

StripRows SortedStrip::sort(const Entry* entries, unsigned count, std::int32_t left,
                            std::int32_t right) {
    const StripRows rows = arrays(count);
    if (!into_buckets(entries, count, left, right)) exactly(entries, count);
    constexpr std::int32_t MOST = std::numeric_limits<std::int32_t>::max();
    for (unsigned i = count; i < count + StripRows::PADDING; ++i)
        put(i, {{{MOST, MOST}, {MOST, MOST}}, 0});
    return rows;
}

std::size_t SortedStrip::bytes() const {
    return 4 * (edges_.capacity() + index_.capacity() + end_.capacity() + places_.capacity()) +
           8 * (keys_.capacity() + spare_.capacity());
}

}  // namespace collision
