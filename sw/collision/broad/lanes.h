// lanes.h - the few vector operations that the kernels need, for each kind of processor.
//
// A kernel is a template over one of the structs below and does its arithmetic with the compiler's
// own vector types: + - > < | act lane by lane, and a comparison gives all ones or all zeros in each
// lane.  What differs between processors is the width, and how the lanes of a comparison become the
// bits of an integer.
//
//     SHORTS, INTS    lanes of 16 and of 32 bits in a vector
//     bits(mask)      bit STRIDE * i is 1 where lane i of a mask of shorts is all ones
//     int_bits(mask)  bit i is 1 where lane i of a mask of ints is all ones
//
// Which of them exist depends on the flags of the file that includes this: Avx2 under -mavx2.  The
// structs have different names, so that no function of one can be linked in place of another's.
#pragma once

#include <cstdint>
#include <cstring>

#if defined(__SSE2__) || defined(__AVX2__)
#include <immintrin.h>
#elif defined(__ARM_NEON)
#include <arm_neon.h>
#endif

namespace collision::lanes {

template <unsigned BYTES>
struct Vectors {
    static constexpr unsigned SHORTS = BYTES / 2, INTS = BYTES / 4;
    using Shorts [[gnu::vector_size(BYTES)]] = std::int16_t;
    using Ints [[gnu::vector_size(BYTES)]] = std::int32_t;
};

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

// Standard C++ but for the vector types, which the compiler takes apart where there are none.
struct Plain : Vectors<16> {
    static constexpr unsigned STRIDE = 8;

    static std::uint64_t bits(Shorts mask) {
        std::uint64_t all = 0;
        for (unsigned i = 0; i < SHORTS; ++i) all |= std::uint64_t{mask[i] & 1u} << (STRIDE * i);
        return all;
    }
    static std::uint32_t int_bits(Ints mask) {
        std::uint32_t all = 0;
        for (unsigned i = 0; i < INTS; ++i) all |= (static_cast<std::uint32_t>(mask[i]) & 1u) << i;
        return all;
    }
};

#if defined(__SSE2__)
struct Sse2 : Vectors<16> {
    static constexpr unsigned STRIDE = 2;

    static std::uint64_t bits(Shorts mask) {
        const int bytes = _mm_movemask_epi8(reinterpret_cast<__m128i>(mask));
        return static_cast<std::uint32_t>(bytes) & 0x5555u;
    }
    static std::uint32_t int_bits(Ints mask) {
        return static_cast<std::uint32_t>(_mm_movemask_ps(reinterpret_cast<__m128>(mask)));
    }
};
#endif

#if defined(__AVX2__)
struct Avx2 : Vectors<32> {
    static constexpr unsigned STRIDE = 2;

    static std::uint64_t bits(Shorts mask) {
        const int bytes = _mm256_movemask_epi8(reinterpret_cast<__m256i>(mask));
        return static_cast<std::uint32_t>(bytes) & 0x55555555u;
    }
    static std::uint32_t int_bits(Ints mask) {
        return static_cast<std::uint32_t>(_mm256_movemask_ps(reinterpret_cast<__m256>(mask)));
    }
};
#endif

#if defined(__ARM_NEON)
struct Neon : Vectors<16> {
    static constexpr unsigned STRIDE = 8;

    static std::uint64_t bits(Shorts mask) {
        const uint8x8_t bytes = vmovn_u16(reinterpret_cast<uint16x8_t>(mask));
        return vget_lane_u64(vreinterpret_u64_u8(bytes), 0) & 0x0101010101010101u;
    }
    static std::uint32_t int_bits(Ints mask) {
        const uint16x4_t shorts = vmovn_u32(reinterpret_cast<uint32x4_t>(mask));
        const std::uint64_t all = vget_lane_u64(vreinterpret_u64_u16(shorts), 0);
        const std::uint64_t sum = (all & 0x0008000400020001u) * 0x0001000100010001u;
        return static_cast<std::uint32_t>(sum >> 48);
    }
};
#endif

}  // namespace collision::lanes
