// collision_pair.h - two polygons or boxes that meet, by their index, and a list of such pairs.
#pragma once

#include <cstdint>
#include <vector>

namespace collision {

struct CollisionPair {
    std::uint32_t first, second;  // first < second

    // Lexicographic, like the alphabet: the paper's cpCmp.
    friend bool operator<(CollisionPair a, CollisionPair b) {
        return a.first != b.first ? a.first < b.first : a.second < b.second;
    }
    friend bool operator==(CollisionPair a, CollisionPair b) {
        return a.first == b.first && a.second == b.second;
    }
};

inline CollisionPair pair_of(std::uint32_t a, std::uint32_t b) {
    return a < b ? CollisionPair{a, b} : CollisionPair{b, a};
}

using PairList = std::vector<CollisionPair>;

}  // namespace collision
