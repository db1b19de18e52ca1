// few.h - brute force over a handful of boxes: one comparison of vectors per pair.
//
// Each box is stored twice, as `low` and `high`, so that the four comparisons of edges are one
// comparison of vectors: `low` of one box with `high` of the other.  Coordinates are complemented
// where the order must be reversed: ~x is -x - 1, which never overflows.
#pragma once

#include <array>
#include <cstdint>
#include <limits>

#include "box_check.h"
#include "collision/collision_pair.h"
#include "collision/polygon.h"

namespace collision {

class Few {
public:
    static constexpr unsigned CAPACITY = 20;  // beyond, Simd is faster
    static constexpr unsigned MOST_PAIRS = CAPACITY * (CAPACITY - 1) / 2;

    // At most CAPACITY polygons.  False, and no more to be done with them, if they do not pass the
    // check.  O(polygons).
    bool accept(Polygons polygons) {
        const unsigned count = polygons.size();
        BoxCheck check;
        for (unsigned i = 0; i < count; ++i) {
            const Four box = check.see(polygons[i]);
            const Four turned = ~exchanged(box);
            low_[i] = __builtin_shufflevector(box, turned, 0, 1, 4, 5);
            high_[i] = __builtin_shufflevector(box, turned, 2, 3, 6, 7);
        }
        constexpr std::int32_t LEAST = std::numeric_limits<std::int32_t>::min();
        for (unsigned i = count; i < count + STEP; ++i) high_[i] = Four{LEAST, LEAST, LEAST, LEAST};
        count_ = count;
        return check.passed();
    }

    // Writes the overlapping pairs, touching included, in lexicographic order; `pairs` has room for
    // MOST_PAIRS.  Returns the end.  O(count^2).
    CollisionPair* find(CollisionPair* pairs) const {
        for (std::uint32_t i = 0; i < count_; ++i)
            for (std::uint32_t j = i + 1; j < count_; j += STEP) {
                // Most pairs do not overlap: one branch for four of them.
                unsigned bits = none(low_[i] > high_[j], low_[i] > high_[j + 1],
                                     low_[i] > high_[j + 2], low_[i] > high_[j + 3]);
                for (; bits; bits &= bits - 1) *pairs++ = {i, j + lowest_bit(bits)};
            }
        return pairs;
    }

private:
    static constexpr unsigned STEP = 4;

    std::array<Four, CAPACITY> low_;
    std::array<Four, CAPACITY + STEP> high_;
    unsigned count_;
};

}  // namespace collision
