// packed_strip.h - the packed entries of one part of the world, in the order of where they begin on
// the x axis: small enough to be moved there themselves.
#pragma once

#include <cstdint>
#include <vector>

#include "collision/broad/kernels.h"
#include "collision/broad/row_store.h"

namespace collision {

class PackedStrip {
public:
    explicit PackedStrip(const Kernels& kernels) : kernels_{&kernels} {}

    // Into the buckets of min.x; PACKED_SLACK entries more are read, whatever they are.  False if
    // most share theirs with many others.  Of `soon`, the entries of the part to come, as many are
    // fetched into the cache meanwhile.  O(count + buckets).
    bool sort(const PackedEntry* entries, unsigned count, const BucketParts& buckets,
              const PackedEntry* soon);

    StripRows rows();  // after sort().  O(count)

    std::size_t bytes() const;  // of memory in use

private:
    const Kernels* kernels_;
    BucketParts buckets_ = {0, 0, 1};
    unsigned count_ = 0;
    std::vector<std::uint32_t> bucket_of_, places_;
    std::vector<PackedEntry> sorted_;
    RowStore store_;
};

}  // namespace collision
