// kernels_avx512.cpp - see kernels_avx512.h
//
// Compiled with -mavx512f, so nothing here may be linked in place of a function of another file:
// all of it is in an unnamed namespace, and what it calls is inlined.
#include "collision/broad/kernels_avx512.h"

#include "collision/broad/kernels_avx2.h"

#if defined(__AVX512F__)
#include <immintrin.h>
#endif

namespace collision {
namespace {

#if defined(__AVX512F__)

constexpr unsigned LANES = 16;

__m512i load(const void* from) { return _mm512_loadu_si512(from); }
__m512i all(std::int32_t value) { return _mm512_set1_epi32(value); }

// With a mask of all lanes, since what g++ 12 makes those without a mask from is uninitialised.
__m512i larger(__m512i a, __m512i b) { return _mm512_maskz_max_epi32(0xffff, a, b); }
__m512i smaller(__m512i a, __m512i b) { return _mm512_maskz_min_epi32(0xffff, a, b); }

// The pairs of a and four lanes of `others`, those from 4 * HALF on.
template <int HALF>
[[gnu::always_inline]] inline void write_four(CollisionPair* to, __m256i a, __m256i others) {
    const __m256i first = _mm256_min_epu32(a, others), second = _mm256_max_epu32(a, others);
    const __m256i order =
        _mm256_add_epi32(_mm256_setr_epi32(0, 8, 1, 9, 2, 10, 3, 11), _mm256_set1_epi32(4 * HALF));
    _mm256_storeu_si256(reinterpret_cast<__m256i*>(to),
                        _mm256_permutex2var_epi32(first, order, second));
}

// The pairs of a and the first `count` lanes of `others`, seldom more than four.  LANES places must
// be left.
[[gnu::always_inline]] inline void append(PairRoom& room, std::uint32_t a, __m512i others,
                                          unsigned count) {
    const __m256i all_a = _mm256_set1_epi32(static_cast<std::int32_t>(a));
    using Ints [[gnu::vector_size(64)]] = std::int32_t;
    const auto ints = reinterpret_cast<Ints>(others);
    const auto eight =
        reinterpret_cast<__m256i>(__builtin_shufflevector(ints, ints, 0, 1, 2, 3, 4, 5, 6, 7));
    write_four<0>(room.next, all_a, eight);
    if (__builtin_expect(count > 4, false)) {
        const auto more = reinterpret_cast<__m256i>(
            __builtin_shufflevector(ints, ints, 8, 9, 10, 11, 12, 13, 14, 15));
        write_four<1>(room.next + 4, all_a, eight);
        write_four<0>(room.next + 8, all_a, more);
        write_four<1>(room.next + 12, all_a, more);
    }
    room.next += count;
}

// The pairs of the ROWS boxes from `row` on with the LANES boxes from `j` on: each vector is loaded
// once for all rows.  FIRST: j is row + 1, and the lanes hold all rows but the first, too.
template <unsigned ROWS, bool FIRST>
[[gnu::always_inline]] inline void sweep_lanes(const StripRows& strip, unsigned row,
                                               std::uint32_t j, PairRoom& room) {
    const std::int32_t *row_min_x = strip.min_x + row, *row_max_x = strip.max_x + row;
    const std::int32_t *row_min_y = strip.min_y + row, *row_max_y = strip.max_y + row;
    const std::uint32_t* row_index = strip.index + row;
    const __m512i min_x = load(strip.min_x + j), max_x = load(strip.max_x + j);
    const __m512i min_y = load(strip.min_y + j), max_y = load(strip.max_y + j);
    const __m512i index = load(strip.index + j);
    for (unsigned k = 0; k < ROWS; ++k) {
        auto hits = static_cast<__mmask16>(FIRST ? 0xffffu << k : 0xffffu);
        hits = _mm512_mask_cmple_epi32_mask(hits, min_x, all(row_max_x[k]));
        hits = _mm512_mask_cmpge_epi32_mask(hits, max_x, all(row_min_x[k]));
        // Of two visitors the higher lower edge, less 1, wraps around to the highest of all.
        const __m512i lower = _mm512_sub_epi32(larger(min_y, all(row_min_y[k])), all(1));
        const __m512i upper = smaller(max_y, all(row_max_y[k]));
        hits = _mm512_mask_cmplt_epi32_mask(hits, lower, upper);
        append(room, row_index[k], _mm512_maskz_compress_epi32(hits, index),
               static_cast<unsigned>(__builtin_popcount(hits)));
    }
}

template <unsigned COUNT>
[[gnu::always_inline]] inline std::int32_t largest(const std::int32_t* of) {
    static_assert(COUNT == 1 || COUNT == 4, "one, or a vector of them");
    if constexpr (COUNT == 1) return *of;
    __m128i max = _mm_loadu_si128(reinterpret_cast<const __m128i*>(of));
    max = _mm_max_epi32(max, _mm_shuffle_epi32(max, 0x4e));  // with those two places away
    max = _mm_max_epi32(max, _mm_shuffle_epi32(max, 0xb1));  // with the neighbours
    return _mm_cvtsi128_si32(max);
}

// The pairs of ROWS boxes from `row` on with those after them.
template <unsigned ROWS>
[[gnu::always_inline]] inline void sweep_rows(const StripRows& strip, unsigned row,
                                              PairRoom& room) {
    const std::int32_t reach = strip.last_in_bucket(largest<ROWS>(strip.max_x + row));
    std::uint32_t j = row + 1;
    sweep_lanes<ROWS, true>(strip, row, j, room);
    for (j += LANES; j < strip.count && strip.min_x[j] <= reach; j += LANES)
        sweep_lanes<ROWS, false>(strip, row, j, room);
}

unsigned strip_rows(const StripRows& rows, unsigned row, PairRoom& to) {
    constexpr unsigned AT_ONCE = 4;
    const StripRows strip = rows;  // copies, or each store of a vector might have changed them
    PairRoom room = to;
    while (row < strip.count && room.left() >= AT_ONCE * (strip.count - row) + LANES) {
        if (row + AT_ONCE <= strip.count) {
            sweep_rows<AT_ONCE>(strip, row, room);
            row += AT_ONCE;
        } else {
            sweep_rows<1>(strip, row++, room);
        }
    }
    to = room;
    return row;
}

#endif

}  // namespace

const Kernels* avx512_kernels() {
#if defined(__AVX512F__)
    if (!__builtin_cpu_supports("avx512f") || !__builtin_cpu_supports("avx512vl")) return nullptr;
    static const Kernels KERNELS = {"AVX-512",
                                    8,
                                    avx2_kernels()->short_rows,
                                    avx2_kernels()->box_cells,
                                    avx2_kernels()->fill_rows,
                                    strip_rows};
    return &KERNELS;
#else
    return nullptr;
#endif
}

}  // namespace collision
