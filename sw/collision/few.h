// few.h - brute force over a handful of boxes: a comparison of vectors a pair, nothing to prepare.
//
// Each box is kept twice, so that four comparisons "this edge lies beyond that one" are one: `low`
// of a box against `high` of the other.  ~x is -x - 1, which turns the order of any two numbers
// round without ever overflowing.
#pragma once

#include <array>
#include <cstdint>

#include "collision/pair_list.h"
#include "collision/polygons.h"
#include "collision/window.h"

namespace collision {

class Few {
public:
    static constexpr unsigned CAPACITY = 20;  // beyond, Simd is faster
    static constexpr unsigned MOST_PAIRS = CAPACITY * (CAPACITY - 1) / 2;

    // count <= CAPACITY.  O(count).
    void assign(const Aabb* boxes, unsigned count) {
        using Ints = BaseLanes::Ints;
        count_ = count;
        for (unsigned i = 0; i < count; ++i) {
            const Ints box = lanes::load<Ints>(&boxes[i]);
            const Ints turned = ~__builtin_shufflevector(box, box, 2, 3, 0, 1);
            low_[i] = __builtin_shufflevector(box, turned, 0, 1, 4, 5);
            high_[i] = __builtin_shufflevector(box, turned, 2, 3, 6, 7);
        }
    }

    // Writes the overlapping pairs, touching included, in lexicographic order; `pairs` has room for
    // MOST_PAIRS.  Returns the end.  O(count^2).
    CollisionPair* find(CollisionPair* pairs) const {
        for (std::uint32_t i = 0; i < count_; ++i)
            for (std::uint32_t j = i + 1; j < count_; ++j)
                if (BaseLanes::int_bits(low_[i] > high_[j]) == 0) *pairs++ = {i, j};
        return pairs;
    }

private:
    std::array<BaseLanes::Ints, CAPACITY> low_, high_;
    unsigned count_;
};

}  // namespace collision
