// lanes.h - the few vector operations that the kernels need, for each kind of processor.
//
// A kernel is a template over one of the structs below and does its arithmetic with the
// compiler's own vector types: + - > < | act lane by lane, and a comparison gives all ones or all
// zeros in each lane.  What differs between processors is the width, and how the lanes of a
// comparison become the bits of an integer.
//
//     SHORTS, INTS    lanes of 16 and of 32 bits in a vector
//     bits(mask)      bit STRIDE * i is 1 where lane i of a mask of shorts is all ones
//     append(pairs, a, others, mask)
//                     the pairs of a and others[i] where lane i of a mask of ints is all ones; INTS
//                     places must be left
//
// Which of them exist depends on the flags of the file that includes this: Avx2 under -mavx2.  The
// structs have different names, so that the linker cannot take a function of one for that of
// another.
#pragma once

#include <array>
#include <cstdint>
#include <cstring>

#if defined(__SSE2__) || defined(__AVX2__)
#include <immintrin.h>
#elif defined(__ARM_NEON)
#include <arm_neon.h>
#endif

#include "four.h"
#include "pair_writer.h"

namespace collision::detail::lanes {

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

// One box per lane, one vector per edge.
template <class Lanes>
struct Edges {
    typename Lanes::Ints min_x, min_y, max_x, max_y;
};

// Lane i is box(i), an Aabb.  A load for each box, or for two at once, then shuffles within 16
// bytes, which are the cheap ones.
template <class Lanes, class Box>
[[gnu::always_inline]] inline Edges<Lanes> edges_of(const Box& box) {
    using Ints = typename Lanes::Ints;
    static_assert(Lanes::INTS == 4 || Lanes::INTS == 8, "vectors of 16 or 32 bytes");
    if constexpr (Lanes::INTS == 4) {
        const Ints a = four(box(0)), b = four(box(1)), c = four(box(2)), d = four(box(3));
        const Ints min_ab = __builtin_shufflevector(a, b, 0, 4, 1, 5);
        const Ints min_cd = __builtin_shufflevector(c, d, 0, 4, 1, 5);
        const Ints max_ab = __builtin_shufflevector(a, b, 2, 6, 3, 7);
        const Ints max_cd = __builtin_shufflevector(c, d, 2, 6, 3, 7);
        return {__builtin_shufflevector(min_ab, min_cd, 0, 1, 4, 5),
                __builtin_shufflevector(min_ab, min_cd, 2, 3, 6, 7),
                __builtin_shufflevector(max_ab, max_cd, 0, 1, 4, 5),
                __builtin_shufflevector(max_ab, max_cd, 2, 3, 6, 7)};
    } else {
        const auto both = [&box](unsigned i) __attribute__((always_inline))->Ints {
            return __builtin_shufflevector(four(box(i)), four(box(i + 4)), 0, 1, 2, 3, 4, 5, 6, 7);
        };
        const Ints a = both(0), b = both(1), c = both(2), d = both(3);
        const Ints min_ab = __builtin_shufflevector(a, b, 0, 8, 1, 9, 4, 12, 5, 13);
        const Ints min_cd = __builtin_shufflevector(c, d, 0, 8, 1, 9, 4, 12, 5, 13);
        const Ints max_ab = __builtin_shufflevector(a, b, 2, 10, 3, 11, 6, 14, 7, 15);
        const Ints max_cd = __builtin_shufflevector(c, d, 2, 10, 3, 11, 6, 14, 7, 15);
        return {__builtin_shufflevector(min_ab, min_cd, 0, 1, 8, 9, 4, 5, 12, 13),
                __builtin_shufflevector(min_ab, min_cd, 2, 3, 10, 11, 6, 7, 14, 15),
                __builtin_shufflevector(max_ab, max_cd, 0, 1, 8, 9, 4, 5, 12, 13),
                __builtin_shufflevector(max_ab, max_cd, 2, 3, 10, 11, 6, 7, 14, 15)};
    }
}

// bits != 0.
[[gnu::always_inline]] inline unsigned lowest_bit(std::uint64_t bits) {
    return static_cast<unsigned>(__builtin_ctzll(bits));
}

// One pair for each 1 in `bits`.
[[gnu::always_inline]] inline void append_bits(PairWriter& pairs, std::uint32_t a,
                                               const std::uint32_t* others, std::uint32_t bits) {
    for (; bits != 0; bits &= bits - 1) pairs.append(a, others[lowest_bit(bits)], true);
}

// Standard C++ except for the vector types, which the compiler splits on processors without
// vectors.
struct Plain : Vectors<16> {
    static constexpr unsigned STRIDE = 8;

    static std::uint64_t bits(Shorts mask) {
        std::uint64_t all = 0;
        for (unsigned i = 0; i < SHORTS; ++i)
            all |= std::uint64_t{static_cast<unsigned>(mask[i]) & 1u} << (STRIDE * i);
        return all;
    }
    static void append(PairWriter& pairs, std::uint32_t a, const std::uint32_t* others, Ints mask) {
        for (unsigned i = 0; i < INTS; ++i) pairs.append(a, others[i], mask[i] != 0);
    }
};

#if defined(__SSE2__)
struct Sse2 : Vectors<16> {
    static constexpr unsigned STRIDE = 2;

    static std::uint64_t bits(Shorts mask) {
        const int bytes = _mm_movemask_epi8(reinterpret_cast<__m128i>(mask));
        return static_cast<std::uint32_t>(bytes) & 0x5555u;
    }
    static void append(PairWriter& pairs, std::uint32_t a, const std::uint32_t* others, Ints mask) {
        const int bits = _mm_movemask_ps(reinterpret_cast<__m128>(mask));
        append_bits(pairs, a, others, static_cast<std::uint32_t>(bits));
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

    // Without a branch on the mask: the wanted lanes are moved to the front, all eight pairs are
    // written, and only those that are wanted count.
    static void append(PairWriter& pairs, std::uint32_t a, const std::uint32_t* others, Ints mask) {
        const unsigned bits = int_bits(mask);
        const __m256i wanted = to_front(load<Ints>(others), bits);
        const __m256i all_a = _mm256_set1_epi32(static_cast<int>(a));
        const __m256i first = _mm256_min_epu32(all_a, wanted);
        const __m256i second = _mm256_max_epu32(all_a, wanted);
        auto* to = reinterpret_cast<__m256i*>(pairs.next);
        _mm256_storeu_si256(to, _mm256_unpacklo_epi32(first, second));
        _mm256_storeu_si256(to + 1, _mm256_unpackhi_epi32(first, second));
        pairs.next += __builtin_popcount(bits);
    }

private:
    static unsigned int_bits(Ints mask) {
        return static_cast<unsigned>(_mm256_movemask_ps(reinterpret_cast<__m256>(mask)));
    }
    static __m256i to_front(Ints numbers, unsigned bits) {
        const __m256i order =
            _mm256_cvtepu8_epi32(_mm_loadl_epi64(reinterpret_cast<const __m128i*>(&FRONT[bits])));
        return _mm256_permutevar8x32_epi32(reinterpret_cast<__m256i>(numbers), order);
    }

    // For each mask the lane that goes to each place, one byte per place.  unpacklo and unpackhi
    // make pairs 0, 1, 4, 5 and 2, 3, 6, 7 of the places 0 .. 7.
    static constexpr std::array<std::uint64_t, 256> front() {
        constexpr unsigned PLACES[] = {0, 1, 4, 5, 2, 3, 6, 7};
        std::array<std::uint64_t, 256> table{};
        for (unsigned bits = 0; bits < 256; ++bits)
            for (unsigned lane = 0, wanted = 0; lane < 8; ++lane)
                if (bits >> lane & 1) table[bits] |= std::uint64_t{lane} << 8 * PLACES[wanted++];
        return table;
    }
    static const std::array<std::uint64_t, 256> FRONT;
};
inline constexpr std::array<std::uint64_t, 256> Avx2::FRONT = Avx2::front();
#endif

#if defined(__ARM_NEON)
struct Neon : Vectors<16> {
    static constexpr unsigned STRIDE = 8;

    static std::uint64_t bits(Shorts mask) {
        const uint8x8_t bytes = vmovn_u16(reinterpret_cast<uint16x8_t>(mask));
        return vget_lane_u64(vreinterpret_u64_u8(bytes), 0) & 0x0101010101010101u;
    }
    static void append(PairWriter& pairs, std::uint32_t a, const std::uint32_t* others, Ints mask) {
        const uint16x4_t shorts = vmovn_u32(reinterpret_cast<uint32x4_t>(mask));
        const std::uint64_t all = vget_lane_u64(vreinterpret_u64_u16(shorts), 0);
        for (auto bits = all & 0x0001000100010001u; bits != 0; bits &= bits - 1)
            pairs.append(a, others[lowest_bit(bits) / 16], true);
    }
};
#endif

}  // namespace collision::detail::lanes
