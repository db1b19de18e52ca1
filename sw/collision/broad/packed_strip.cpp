// packed_strip.cpp - see packed_strip.h
#include "collision/broad/packed_strip.h"

#include "collision/broad/places.h"

namespace collision {

bool PackedStrip::sort(const PackedEntry* entries, unsigned count, const BucketParts& buckets,
                       const PackedEntry* soon) {
    count_ = count;
    buckets_ = buckets;
    if (sorted_.size() < count + PACKED_SLACK) {
        sorted_.resize(count + count / 8 + PACKED_SLACK);
        bucket_of_.resize(sorted_.size());
    }
    const std::uint32_t* bucket_of = bucket_of_.data();
    kernels_->packed_buckets(entries, count, buckets, bucket_of_.data());
    places_.assign(buckets.count, 0);
    std::uint32_t* places = places_.data();
    for (unsigned i = 0; i < count; ++i) ++places[bucket_of[i]];
    if (!make_places(places_)) return false;

    constexpr unsigned IN_LINE = 64 / sizeof(PackedEntry);
    PackedEntry* sorted = sorted_.data();
    for (unsigned i = 0; i < count; ++i) {
        sorted[places[bucket_of[i]]++] = entries[i];
        if (i % IN_LINE == 0) __builtin_prefetch(soon + i, 0, 2);
    }
    std::fill_n(sorted + count, PACKED_SLACK, sorted[0]);
    return true;
}

StripRows PackedStrip::rows() {
    const std::int32_t narrowest =
        kernels_->packed_rows(sorted_.data(), count_, store_.arrays(count_));
    return store_.rows(count_, buckets_, narrowest);
}

std::size_t PackedStrip::bytes() const {
    return 4 * (bucket_of_.capacity() + places_.capacity()) +
           sorted_.capacity() * sizeof(PackedEntry) + store_.bytes();
}

}  // namespace collision
