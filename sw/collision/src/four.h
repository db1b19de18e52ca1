// four.h - four 32-bit numbers at a time, on every processor.
#pragma once

#include <cstdint>
#include <cstring>

#if defined(__SSE2__)
#include <emmintrin.h>
#elif defined(__ARM_NEON)
#include <arm_neon.h>
#endif

namespace collision {

// The compiler's own vector type: + < | act lane by lane, a comparison gives all ones or all zeros.
using Four [[gnu::vector_size(16)]] = std::int32_t;

// 16 bytes from any address that is a multiple of 4: an Aabb, or a Line.
template <class Value>
[[gnu::always_inline]] inline Four four(const Value& value) {
    static_assert(sizeof(Value) == sizeof(Four), "four coordinates");
    Four vector;
    std::memcpy(&vector, &value, sizeof vector);
    return vector;
}

// The last two lanes before the first two.
[[gnu::always_inline]] inline Four exchanged(Four v) {
    return __builtin_shufflevector(v, v, 2, 3, 0, 1);
}

// Is any lane of a comparison all ones?
[[gnu::always_inline]] inline bool any(Four comparison) {
#if defined(__SSE2__)
    return _mm_movemask_epi8(reinterpret_cast<__m128i>(comparison)) != 0;
#elif defined(__ARM_NEON)
    const uint16x4_t shorts = vmovn_u32(reinterpret_cast<uint32x4_t>(comparison));
    return vget_lane_u64(vreinterpret_u64_u16(shorts), 0) != 0;
#else
    return (comparison[0] | comparison[1] | comparison[2] | comparison[3]) != 0;
#endif
}

// Bit k is 1 where no lane of the k-th comparison is all ones.
[[gnu::always_inline]] inline unsigned none(Four a, Four b, Four c, Four d) {
#if defined(__SSE2__)
    const auto packed = [](Four p, Four q) {
        return _mm_packs_epi32(reinterpret_cast<__m128i>(p), reinterpret_cast<__m128i>(q));
    };
    const __m128i bytes = _mm_packs_epi16(packed(a, b), packed(c, d));
    const __m128i none = _mm_cmpeq_epi32(bytes, _mm_setzero_si128());
    return static_cast<unsigned>(_mm_movemask_ps(_mm_castsi128_ps(none)));
#else
    return (any(a) ? 0 : 1u) | (any(b) ? 0 : 2u) | (any(c) ? 0 : 4u) | (any(d) ? 0 : 8u);
#endif
}

// The place of the lowest bit that is 1; `bits` is not 0.
inline unsigned lowest_bit(unsigned bits) { return static_cast<unsigned>(__builtin_ctz(bits)); }

}  // namespace collision
