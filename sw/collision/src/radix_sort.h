// radix_sort.h - numbers in increasing order, in time proportional to how many there are.
#pragma once

#include <cstdint>
#include <vector>

namespace collision::detail {

// The position in the upper half, biased so that it orders as unsigned; the index in the lower.
inline std::uint64_t sort_key(std::int32_t position, std::uint32_t index) {
    return std::uint64_t{static_cast<std::uint32_t>(position) ^ 0x80000000u} << 32 | index;
}

inline std::uint32_t index_of(std::uint64_t key) { return static_cast<std::uint32_t>(key); }

// Sorts by the upper 32 bits; equal ones keep their order.  `spare` is resized to match.  Three
// passes of 11 bits, fewer where all numbers have a digit in common: O(count).
//
// Source: Knuth, The Art of Computer Programming 3, 5.2.5, least significant digit first.
void radix_sort(std::vector<std::uint64_t>& keys, std::vector<std::uint64_t>& spare);

}  // namespace collision::detail
