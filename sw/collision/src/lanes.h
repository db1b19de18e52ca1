// lanes.h - the few vector operations that the broad phases need, for each kind of processor.
//
// Arithmetic is the compiler's own vector types: + - > < | act lane by lane, and a comparison gives
// all ones or all zeros in each lane.  What differs between processors is how the lanes of a
// comparison become the bits of an integer.  COLLISION_PLAIN chooses what processors without
// vectors get, for a test.
#pragma once

#include <cstdint>
#include <cstring>

#if defined(__SSE2__)
#include <emmintrin.h>
#elif defined(__ARM_NEON)
#include <arm_neon.h>
#endif

#include "pair_writer.h"

namespace collision::lanes {

constexpr unsigned SHORTS = 8, INTS = 4;  // of 16 and of 32 bits in a vector
using Shorts [[gnu::vector_size(16)]] = std::int16_t;
using Ints [[gnu::vector_size(16)]] = std::int32_t;

// From any address that is a multiple of the element's size.
template <class Vector, class Element>
[[gnu::always_inline]] inline Vector load(const Element* from) {
    Vector vector;
    std::memcpy(&vector, from, sizeof vector);
    return vector;
}

// bits != 0.
[[gnu::always_inline]] inline unsigned lowest_bit(std::uint64_t bits) {
    return static_cast<unsigned>(__builtin_ctzll(bits));
}

// bits(mask): bit STRIDE * i is 1 where lane i of a mask is all ones.
//
// append(pairs, a, others, mask): the pairs of a and others[i] where lane i of a mask is all ones;
// INTS places must be left.
#if defined(__SSE2__) && !defined(COLLISION_PLAIN)
constexpr unsigned STRIDE = 2;

[[gnu::always_inline]] inline std::uint64_t bits(Shorts mask) {
    return static_cast<std::uint32_t>(_mm_movemask_epi8(reinterpret_cast<__m128i>(mask))) & 0x5555u;
}
[[gnu::always_inline]] inline void append(PairWriter& pairs, std::uint32_t a,
                                          const std::uint32_t* others, Ints mask) {
    auto all = static_cast<unsigned>(_mm_movemask_ps(reinterpret_cast<__m128>(mask)));
    for (; all != 0; all &= all - 1) pairs.append(a, others[lowest_bit(all)], true);
}
#elif defined(__ARM_NEON) && !defined(COLLISION_PLAIN)
constexpr unsigned STRIDE = 8;

[[gnu::always_inline]] inline std::uint64_t bits(Shorts mask) {
    const uint8x8_t bytes = vmovn_u16(reinterpret_cast<uint16x8_t>(mask));
    return vget_lane_u64(vreinterpret_u64_u8(bytes), 0) & 0x0101010101010101u;
}
[[gnu::always_inline]] inline void append(PairWriter& pairs, std::uint32_t a,
                                          const std::uint32_t* others, Ints mask) {
    const uint16x4_t shorts = vmovn_u32(reinterpret_cast<uint32x4_t>(mask));
    std::uint64_t all = vget_lane_u64(vreinterpret_u64_u16(shorts), 0) & 0x0001000100010001u;
    for (; all != 0; all &= all - 1) pairs.append(a, others[lowest_bit(all) / 16], true);
}
#else
constexpr unsigned STRIDE = 8;

inline std::uint64_t bits(Shorts mask) {
    std::uint64_t all = 0;
    for (unsigned i = 0; i < SHORTS; ++i)
        all |= std::uint64_t{static_cast<unsigned>(mask[i]) & 1u} << (STRIDE * i);
    return all;
}
inline void append(PairWriter& pairs, std::uint32_t a, const std::uint32_t* others, Ints mask) {
    for (unsigned i = 0; i < INTS; ++i) pairs.append(a, others[i], mask[i] != 0);
}
#endif

}  // namespace collision::lanes
