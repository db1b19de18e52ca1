// few.h - brute force over a handful of boxes: a comparison of vectors a pair, nothing to prepare.
//
// Each box is kept twice, so that four comparisons "this edge lies beyond that one" are one: `low`
// of a box against `high` of the other.  ~x is -x - 1, which turns the order of any two numbers
// round without ever overflowing.
#pragma once

#include <array>
#include <cstdint>
#include <limits>

#include "collision/box_check.h"
#include "collision/pair_list.h"
#include "collision/polygons.h"
#include "collision/window.h"

namespace collision {

class Few {
public:
    static constexpr unsigned CAPACITY = 20;  // beyond, Simd is faster
    static constexpr unsigned MOST_PAIRS = CAPACITY * (CAPACITY - 1) / 2;

    // At most CAPACITY polygons.  False, and no more to be done with them, if they do not pass the
    // check.  O(polygons).
    bool take(Polygons polygons) {
        using Ints = BaseLanes::Ints;
        const unsigned count = polygons.size();
        BoxCheck check;
        for (unsigned i = 0; i < count; ++i) {
            const Ints box = check.see(polygons[i]);
            const Ints turned = ~__builtin_shufflevector(box, box, 2, 3, 0, 1);
            low_[i] = __builtin_shufflevector(box, turned, 0, 1, 4, 5);
            high_[i] = __builtin_shufflevector(box, turned, 2, 3, 6, 7);
        }
        constexpr std::int32_t LEAST = std::numeric_limits<std::int32_t>::min();
        for (unsigned i = count; i < count + STEP; ++i) high_[i] = Ints{LEAST, LEAST, LEAST, LEAST};
        count_ = count;
        return check.passed();
    }

    // Writes the overlapping pairs, touching included, in lexicographic order; `pairs` has room for
    // MOST_PAIRS.  Returns the end.  O(count^2).
    CollisionPair* find(CollisionPair* pairs) const {
        for (std::uint32_t i = 0; i < count_; ++i)
            for (std::uint32_t j = i + 1; j < count_; j += STEP) {
                // Most are apart: one branch for four pairs.
                unsigned bits = none_beyond(low_[i] > high_[j], low_[i] > high_[j + 1],
                                            low_[i] > high_[j + 2], low_[i] > high_[j + 3]);
                for (; bits; bits &= bits - 1) *pairs++ = {i, j + lanes::lowest_bit(bits)};
            }
        return pairs;
    }

private:
    static constexpr unsigned STEP = 4;

    // Bit k is 1 where all lanes of the k-th comparison are 0.
    static unsigned none_beyond(BaseLanes::Ints a, BaseLanes::Ints b, BaseLanes::Ints c,
                                BaseLanes::Ints d) {
#if defined(__SSE2__)
        const auto packed = [](BaseLanes::Ints p, BaseLanes::Ints q) {
            return _mm_packs_epi32(reinterpret_cast<__m128i>(p), reinterpret_cast<__m128i>(q));
        };
        const __m128i bytes = _mm_packs_epi16(packed(a, b), packed(c, d));
        return BaseLanes::int_bits(reinterpret_cast<BaseLanes::Ints>(bytes) == 0);
#else
        const auto bit = [](BaseLanes::Ints p, unsigned k) {
            return static_cast<unsigned>(BaseLanes::int_bits(p) == 0) << k;
        };
        return bit(a, 0) | bit(b, 1) | bit(c, 2) | bit(d, 3);
#endif
    }

    std::array<BaseLanes::Ints, CAPACITY> low_;
    std::array<BaseLanes::Ints, CAPACITY + STEP> high_;
    unsigned count_;
};

}  // namespace collision
