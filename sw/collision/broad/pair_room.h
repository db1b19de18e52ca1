// pair_room.h - fills a list of pairs through plain pointers: push_back costs time.
#pragma once

#include <cstddef>

#include "collision/pair_list.h"

namespace collision {

// Where the next pair of a list goes and where its places end.  A kernel works on a copy and hands
// that back: the compiler keeps it in registers.  Writes over what the list holds; within its old
// size nothing is allocated or cleared.
class PairRoom {
public:
    explicit PairRoom(PairList& list)
        : next{list.data()}, end_{list.data() + list.size()}, list_{&list} {}

    CollisionPair* next;

    [[gnu::always_inline]] std::size_t left() const {
        return static_cast<std::size_t>(end_ - next);
    }

    // At least so many places.  New ones are cleared by the vector, so ask for few.
    [[gnu::always_inline]] void need(std::size_t places) {
        if (left() < places) *this = larger(places);
    }

    // Appends a pair if `wanted` is true, without a branch.  At least one place must be left.
    [[gnu::always_inline]] void append(std::uint32_t a, std::uint32_t b, bool wanted) {
        *next = a < b ? CollisionPair{a, b} : CollisionPair{b, a};
        next += wanted;
    }

    void finish() { list_->resize(used()); }  // to what was written

private:
    std::size_t used() const { return static_cast<std::size_t>(next - list_->data()); }
    PairRoom larger(std::size_t places) const;

    CollisionPair* end_;
    PairList* list_;
};

}  // namespace collision
