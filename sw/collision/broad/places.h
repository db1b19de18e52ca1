// places.h - a counting sort's places, from how many there are of each number.
#pragma once

#include <cstdint>
#include <vector>

namespace collision {

// Makes each count the place where its bucket begins.  False if most boxes share their bucket with
// many others: what compares them is then out of proportion.  O(counts).
//
// Boxes spread at random with m others in their bucket on average: the sum of the squares of the
// numbers of boxes is then m + 1 times the number of boxes.  A few vectors of others cost less than
// to cut the world again.
inline bool make_places(std::vector<std::uint32_t>& counts) {
    constexpr std::uint64_t UNEVEN = 32;
    std::uint32_t place = 0;
    std::uint64_t squares = 0;
    for (std::uint32_t& in_bucket : counts) {
        const std::uint32_t count = in_bucket;
        squares += std::uint64_t{count} * count;
        in_bucket = place;
        place += count;
    }
    return squares <= UNEVEN * place;
}

}  // namespace collision
