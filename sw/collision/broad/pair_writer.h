// pair_writer.h - fills a list of pairs through plain pointers: push_back costs time.
#pragma once

#include <algorithm>
#include <cstddef>

#include "collision/broad/huge_pages.h"
#include "collision/pair_list.h"

namespace collision {

// A place to write and where it ends.
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

// Writes over what `list` holds.  Within its old size nothing is allocated or cleared.
class PairWriter {
public:
    explicit PairWriter(PairList& list) : list_{list} {}

    // Calls fill(PairRoom&) until it returns true, each time that it returns false with room for
    // `more` pairs more.  New room is cleared by the vector, so little of it is better.
    template <class Fill>
    void write(std::size_t more, Fill fill) {
        for (;;) {
            PairRoom room = {list_.data() + used_, list_.data() + list_.size()};
            const bool done = fill(room);
            used_ = static_cast<std::size_t>(room.next - list_.data());
            if (done) return;
            grow(list_.size() + more);
        }
    }

    void finish() { list_.resize(used_); }  // to what was written

private:
    void grow(std::size_t size) {
        if (size > list_.capacity()) {
            PairList larger;
            reserve_in_huge_pages(larger, std::max(size, 2 * list_.size()));
            larger.assign(list_.begin(), list_.end());
            list_.swap(larger);
        }
        list_.resize(size);
    }

    PairList& list_;
    std::size_t used_ = 0;
};

}  // namespace collision
