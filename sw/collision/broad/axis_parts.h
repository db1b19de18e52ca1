// axis_parts.h - equal parts of an axis: which of them a position belongs to.
#pragma once

#include <algorithm>
#include <cstdint>

namespace collision {

// Parts of a power of two of units from `first` to `last`; positions outside belong to the first
// and the last part.  Keeps the order of any two positions, so boxes that overlap have a part in
// common.
struct AxisParts {
    std::int32_t first, last;
    unsigned shift, count;

    // At most `wanted` parts, and more than half as many where there are as many units.  from <= to,
    // wanted > 0.
    AxisParts(std::int32_t from, std::int32_t to, unsigned wanted)
        : first{from}, last{wanted > 1 ? to : from}, shift{0} {
        const std::uint32_t span = offset(last);
        while (span >> shift >= wanted) ++shift;
        count = (span >> shift) + 1;
    }

    [[gnu::always_inline]] std::uint32_t operator()(std::int32_t at) const {
        return offset(at < first ? first : at > last ? last : at) >> shift;
    }

private:
    [[gnu::always_inline]] std::uint32_t offset(std::int32_t at) const {
        return static_cast<std::uint32_t>(at) - static_cast<std::uint32_t>(first);
    }
};

// Strips across the y axis, each cut into the same buckets along the x axis.  Cells are numbered
// strip by strip.
struct GridParts {
    AxisParts strips, buckets;

    unsigned cells() const { return strips.count * buckets.count; }
};

}  // namespace collision
