// pair_writer.h - fills a list of pairs through plain pointers, because push_back costs time.
#pragma once

#include <cstddef>

#include "collision/collision_pair.h"

namespace collision {

// Points to the place of the next pair in a list, and to the end of its places.  It overwrites the
// list's content; within the old size nothing is allocated or cleared.  An inner loop works on a
// copy of this object, so that the compiler keeps it in registers.
class PairWriter {
public:
    explicit PairWriter(PairList& list)
        : next{list.data()}, end_{list.data() + list.size()}, list_{&list} {}

    CollisionPair* next;

    // Ensures at least so many places.  The vector clears new ones, so ask for few.
    [[gnu::always_inline]] void need(std::size_t places) {
        if (static_cast<std::size_t>(end_ - next) < places) *this = larger(places);
    }

    // Appends a pair if `wanted` is true, without a branch.  At least one place must be left.
    [[gnu::always_inline]] void append(std::uint32_t a, std::uint32_t b, bool wanted) {
        *next = a < b ? CollisionPair{a, b} : CollisionPair{b, a};
        next += wanted;
    }

    void finish() { list_->resize(used()); }  // to what was written

private:
    std::size_t used() const { return static_cast<std::size_t>(next - list_->data()); }
    [[gnu::noinline]] PairWriter larger(std::size_t places) const {
        const std::size_t written = used();
        list_->resize(written + places);
        PairWriter writer(*list_);
        writer.next += written;
        return writer;
    }

    CollisionPair* end_;
    PairList* list_;
};

}  // namespace collision
