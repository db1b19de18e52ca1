// grid_parts.h - strips across the y axis, cut into buckets along the x axis.
#pragma once

#include <algorithm>
#include <cstdint>

namespace collision {

// The distance from `first`.  Positions outside `first` to `last` belong to the first and the last
// part of an axis.
[[gnu::always_inline]] inline std::uint32_t offset_in(std::int32_t first, std::int32_t last,
                                                      std::int32_t at) {
    return static_cast<std::uint32_t>(at < first  ? first
                                      : at > last ? last
                                                  : at) -
           static_cast<std::uint32_t>(first);
}

// Equal strips, to within 2^-16 of all.  Keeps the order of any two positions, so that boxes that
// overlap have a strip in common.  All in 32 bits, since vectors have no wider product: `shift`
// makes 16 of an offset.
struct StripParts {
    std::int32_t first, last;
    unsigned count, shift;
    std::uint32_t scale;  // strips times 2^16 an offset shifted

    // At most `wanted` strips, fewer where there are fewer units.  from <= to, 0 < wanted < 2^16.
    StripParts(std::int32_t from, std::int32_t to, unsigned wanted)
        : first{from}, last{to}, shift{0} {
        const std::uint32_t span = offset_in(first, last, last);
        while (span >> shift >= 1u << 16) ++shift;
        const std::uint32_t units = (span >> shift) + 1;
        count = static_cast<unsigned>(std::min<std::uint32_t>(wanted, units));
        scale = static_cast<std::uint32_t>((std::uint64_t{count} << 16) / units);
    }
    [[gnu::always_inline]] std::uint32_t operator()(std::int32_t at) const {
        return (offset_in(first, last, at) >> shift) * scale >> 16;
    }
};

// Buckets of a power of two of units.  Keeps the order, too.
struct BucketParts {
    std::int32_t first, last;
    unsigned shift, count;

    // At most `wanted` buckets, and more than half as many where there are as many units.
    // from <= to, wanted > 0; one bucket has no width.
    BucketParts(std::int32_t from, std::int32_t to, unsigned wanted)
        : first{from}, last{wanted > 1 ? to : from}, shift{0} {
        const std::uint32_t span = offset_in(first, last, last);
        while (span >> shift >= wanted) ++shift;
        count = (span >> shift) + 1;
    }
};

// Cells are numbered strip by strip.
struct GridParts {
    StripParts strips;
    BucketParts buckets;

    unsigned cells() const { return strips.count * buckets.count; }
};

}  // namespace collision
