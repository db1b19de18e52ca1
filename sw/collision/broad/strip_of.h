// strip_of.h - equal parts of an axis: which of them a position belongs to.
#pragma once

#include <algorithm>
#include <cstdint>

namespace collision {

// `count` strips from `bottom` to `top`; positions outside belong to the first and the last.  Keeps
// the order of any two positions, so boxes that overlap have a strip in common.
struct StripOf {
    std::int32_t bottom, top;
    unsigned count;
    std::uint64_t scale;  // strips a unit, times 2^32

    // bottom <= top, count > 0.
    StripOf(std::int32_t from, std::int32_t to, unsigned wanted)
        : bottom{from}, top{to}, count{wanted}, scale{(std::uint64_t{wanted} << 32) / units()} {}

    std::uint32_t operator()(std::int32_t at) const {
        const std::uint32_t offset =
            static_cast<std::uint32_t>(std::min(std::max(at, bottom), top)) -
            static_cast<std::uint32_t>(bottom);
        return static_cast<std::uint32_t>(offset * scale >> 32);
    }

private:
    std::uint64_t units() const {
        return std::uint64_t{static_cast<std::uint32_t>(top) - static_cast<std::uint32_t>(bottom)} +
               1;
    }
};

// The same, for entries that are known to lie in one strip.
struct OneStrip {
    static constexpr unsigned count = 1;

    std::uint32_t operator()(std::int32_t) const { return 0; }
};

// Buckets of a power of two of units, at most `wanted` of them, from `left` to `right`.
struct BucketOf {
    std::int32_t left, right;
    unsigned shift, count;

    // left <= right, wanted > 0.
    BucketOf(std::int32_t from, std::int32_t to, unsigned wanted)
        : left{from}, right{to}, shift{0} {
        const std::uint32_t span = offset(right);
        while (span >> shift >= wanted) ++shift;
        count = (span >> shift) + 1;
    }

    std::uint32_t operator()(std::int32_t at) const {
        return offset(std::min(std::max(at, left), right)) >> shift;
    }

private:
    std::uint32_t offset(std::int32_t at) const {
        return static_cast<std::uint32_t>(at) - static_cast<std::uint32_t>(left);
    }
};

}  // namespace collision
