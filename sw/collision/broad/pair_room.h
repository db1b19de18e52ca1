// pair_room.h - a list of pairs as the kernels see it: a place to write and where it ends.
#pragma once

#include <cstddef>

#include "collision/pair_list.h"

namespace collision {

struct PairRoom {
    CollisionPair* next;
    CollisionPair* end;

    std::size_t left() const { return static_cast<std::size_t>(end - next); }

    // Appends a pair if `wanted` is true, without a branch.  At least one place must be left.
    [[gnu::always_inline]] void append(std::uint32_t a, std::uint32_t b, bool wanted) {
        *next = a < b ? CollisionPair{a, b} : CollisionPair{b, a};
        next += wanted;
    }
};

// Fills `list` by calling fill(PairRoom&) until that returns true, with more room each time it
// returns false: at least twice of what there was and `least` more.  Within the list's old size
// nothing is allocated or cleared.
template <class Fill>
void fill_list(PairList& list, std::size_t least, Fill fill) {
    for (std::size_t used = 0;;) {
        PairRoom room = {list.data() + used, list.data() + list.size()};
        const bool done = fill(room);
        used = static_cast<std::size_t>(room.next - list.data());
        if (done) return list.resize(used);
        list.resize(2 * list.size() + least);
    }
}

}  // namespace collision
