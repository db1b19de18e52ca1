// window.h - which lines of a polygon reach into a box.
#pragma once

#include "collision/polygon.h"

#if defined(__SSE2__)
#include <emmintrin.h>
#endif

namespace collision {

// A line is left out if both its ends lie beyond the same side of the box.  One that passes by a
// corner may be kept: it is for the line test to say.
class Window {
public:
    explicit Window(const Aabb& box)
#if defined(__SSE2__)
        : min_{_mm_set_epi32(box.min.y, box.min.x, box.min.y, box.min.x)},
          max_{_mm_set_epi32(box.max.y, box.max.x, box.max.y, box.max.x)} {}
#else
        : box_{box} {
    }
#endif

          // Copies those of `polygon` that may reach into the box to `lines`, which has room for
          // MAX_LINES, in their order, and returns how many they are.  O(lines), without a branch.
          unsigned reached_by(const Polygon& polygon, Line* lines) const {
        unsigned count = 0;
        for (unsigned i = 0; i < polygon.count; ++i) {
            lines[count] = polygon.lines[i];
            count += !misses(polygon.lines[i]);
        }
        return count;
    }

private:
#if defined(__SSE2__)
    bool misses(const Line& line) const {
        const __m128i ends = _mm_loadu_si128(reinterpret_cast<const __m128i*>(&line));
        const __m128i below = _mm_cmplt_epi32(ends, min_), above = _mm_cmpgt_epi32(ends, max_);
        // x and y of one end in the low half, of the other in the high half.
        const __m128i both = _mm_or_si128(_mm_and_si128(below, _mm_unpackhi_epi64(below, below)),
                                          _mm_and_si128(above, _mm_unpackhi_epi64(above, above)));
        return _mm_cvtsi128_si64(both) != 0;
    }

    __m128i min_, max_;
#else
    bool misses(const Line& line) const {
        const auto& [a, b] = line;
        return (a.x < box_.min.x) & (b.x < box_.min.x) || (a.x > box_.max.x) & (b.x > box_.max.x) ||
               (a.y < box_.min.y) & (b.y < box_.min.y) || (a.y > box_.max.y) & (b.y > box_.max.y);
    }

    Aabb box_;
#endif
};

}  // namespace collision
