// kernels_avx512.cpp - see kernels_avx512.h
//
// strip_rows compares a block of rows, then writes its pairs:
//
//     sweep_near   each four rows with the sixteen boxes after them, which is mostly all
//     find_far     which of them may reach beyond those
//     sweep_far    these few, to where they end
//     write        bits to pairs
//
// What would be a branch that no processor foresees is a number of things that are written and may
// be written over.
//
// Compiled with -mavx512f, so nothing here may be linked in place of a function of another file:
// all of it is in an unnamed namespace, and what it calls is inlined.
#include "collision/broad/kernels_avx512.h"

#include "collision/broad/kernels_avx2.h"

#if defined(__AVX512VBMI2__)
#include <immintrin.h>
#endif

namespace collision {
namespace {

#if defined(__AVX512VBMI2__)

constexpr unsigned LANES = 16;

__m512i load(const void* from) { return _mm512_loadu_si512(from); }
__m512i all(std::int32_t value) { return _mm512_set1_epi32(value); }

// With a mask of all lanes, or as a shuffle: what g++ 12 makes some others from is uninitialised.
__m512i larger(__m512i a, __m512i b) { return _mm512_maskz_max_epi32(0xffff, a, b); }
__m512i smaller(__m512i a, __m512i b) { return _mm512_maskz_min_epi32(0xffff, a, b); }

__m256i lower_half(__m512i all) {
    using Ints [[gnu::vector_size(64)]] = std::int32_t;
    const auto ints = reinterpret_cast<Ints>(all);
    return reinterpret_cast<__m256i>(__builtin_shufflevector(ints, ints, 0, 1, 2, 3, 4, 5, 6, 7));
}

constexpr unsigned ROWS = 4;    // compared at once with LANES others: each vector is loaded once
constexpr unsigned BLOCK = 64;  // times ROWS; their hits are collected first and told apart later

struct Hits {
    std::uint64_t bits;        // LANES * k + i: row + k and other + i overlap
    std::uint32_t row, other;  // the first of ROWS, and of LANES
};

// IN_ORDER: no other ends before a row begins.
template <bool IN_ORDER>
[[gnu::always_inline]] inline Hits compare(const StripRows& strip, std::uint32_t row,
                                           std::uint32_t other) {
    const std::int32_t *row_min_x = strip.min_x + row, *row_max_x = strip.max_x + row;
    const std::int32_t *row_min_y = strip.min_y + row, *row_max_y = strip.max_y + row;
    const __m512i min_x = load(strip.min_x + other), max_x = load(strip.max_x + other);
    const __m512i min_y = load(strip.min_y + other), max_y = load(strip.max_y + other);
    std::uint64_t bits = 0;
#pragma GCC unroll 4
    for (unsigned k = 0; k < ROWS; ++k) {
        __mmask16 hits = _mm512_cmple_epi32_mask(min_x, all(row_max_x[k]));
        if constexpr (!IN_ORDER)
            hits = _mm512_mask_cmpge_epi32_mask(hits, max_x, all(row_min_x[k]));
        // Of two visitors the higher lower edge, less 1, wraps around to the highest of all.
        const __m512i lower = _mm512_sub_epi32(larger(min_y, all(row_min_y[k])), all(1));
        const __m512i upper = smaller(max_y, all(row_max_y[k]));
        hits = _mm512_mask_cmplt_epi32_mask(hits, lower, upper);
        bits |= std::uint64_t{hits} << LANES * k;
    }
    return {bits, row, other};
}

// Each row with the LANES after the first of its four; the one after the last is the last's own.
template <bool IN_ORDER>
[[gnu::noinline]] Hits* sweep_near(const StripRows& strip, unsigned row, unsigned end, Hits* next) {
    constexpr std::uint64_t AFTER = 0xfff8'fffc'fffe'ffff;  // the row itself
    for (; row < end; row += ROWS) {
        *next = compare<IN_ORDER>(strip, row, row + 1);
        next++->bits &= AFTER;
    }
    return next;
}

// StripRows::last_in_bucket() of the farthest of each four rows, in all four lanes.
[[gnu::always_inline]] inline __m512i reaches(const StripRows& strip, unsigned row) {
    __m512i max = load(strip.max_x + row);
    max = larger(max, _mm512_maskz_shuffle_epi32(0xffff, max, _MM_PERM_BADC));
    max = larger(max, _mm512_maskz_shuffle_epi32(0xffff, max, _MM_PERM_CDAB));
    const __m512i left = all(strip.left), right = all(strip.right);
    const __m512i offset = _mm512_sub_epi32(smaller(larger(max, left), right), left);
    const __m512i last = _mm512_or_epi32(offset, all(static_cast<std::int32_t>(strip.mask)));
    const __mmask16 limited = _mm512_cmplt_epu32_mask(last, _mm512_sub_epi32(right, left));
    return _mm512_mask_add_epi32(all(std::numeric_limits<std::int32_t>::max()), limited, last,
                                 left);
}

// Writes to `far` the first of each four rows that may reach beyond the LANES after it.  Without a
// branch: which ones do is hard to foresee.  Up to LANES places more are written.
[[gnu::noinline]] std::uint32_t* find_far(const StripRows& strip, unsigned row, unsigned end,
                                          std::uint32_t* far) {
    constexpr __mmask16 FIRST_OF_FOUR = 0x1111;
    for (; row < end; row += LANES) {
        const __m512i beyond = load(strip.min_x + row + 1 + LANES);
        const __mmask16 reached =
            _mm512_mask_cmple_epi32_mask(FIRST_OF_FOUR, beyond, reaches(strip, row));
        const __m512i rows = _mm512_add_epi32(
            all(static_cast<std::int32_t>(row)),
            _mm512_setr_epi32(0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15));
        _mm512_storeu_si512(far, _mm512_maskz_compress_epi32(reached, rows));
        far += __builtin_popcount(reached);
    }
    return far;
}

// The pairs of up to eight hits, a byte each: their place in Hits::bits.
[[gnu::always_inline]] inline void write_eight(CollisionPair* to, __m128i hits, __m256i rows,
                                               __m512i others) {
    const __m256i hit = _mm256_cvtepu8_epi32(hits);
    const __m256i row = _mm256_srli_epi32(hit, 4);  // of which the lowest two bits count below
    const auto a =
        reinterpret_cast<__m256i>(_mm256_permutevar_ps(reinterpret_cast<__m256>(rows), row));
    const __m256i b =
        lower_half(_mm512_maskz_permutexvar_epi32(0xffff, _mm512_castsi256_si512(hit), others));
    const __m256i first = _mm256_min_epu32(a, b), second = _mm256_max_epu32(a, b);
    const __m256i lower = _mm256_setr_epi32(0, 8, 1, 9, 2, 10, 3, 11);
    const __m256i upper = _mm256_setr_epi32(4, 12, 5, 13, 6, 14, 7, 15);
    auto* pairs = reinterpret_cast<__m256i*>(to);
    _mm256_storeu_si256(pairs, _mm256_permutex2var_epi32(first, lower, second));
    _mm256_storeu_si256(pairs + 1, _mm256_permutex2var_epi32(first, upper, second));
}

struct Places {
    alignas(64) std::uint8_t of_bits[64];

    constexpr Places() : of_bits{} {
        for (unsigned i = 0; i < 64; ++i) of_bits[i] = static_cast<std::uint8_t>(i);
    }
};
constexpr Places PLACES;

[[gnu::noinline]] void write(const StripRows& strip, const Hits* from, const Hits* to,
                             PairRoom& room) {
    constexpr unsigned AT_ONCE = 8, AHEAD = 256;  // pairs
    if (room.left() < LANES * ROWS * BLOCK + AT_ONCE) {
        std::size_t count = AT_ONCE;
        for (const Hits* hits = from; hits < to; ++hits)
            count += static_cast<unsigned>(__builtin_popcountll(hits->bits));
        room.need(count);
    }
    CollisionPair* next = room.next;
    for (; from < to; ++from) {
        __builtin_prefetch(next + AHEAD, 1);
        const __m512i others = load(strip.index + from->other);
        const __m256i rows = _mm256_broadcastsi128_si256(
            _mm_loadu_si128(reinterpret_cast<const __m128i*>(strip.index + from->row)));
        const __m512i hits = _mm512_maskz_compress_epi8(from->bits, load(PLACES.of_bits));
        write_eight(next, _mm256_castsi256_si128(lower_half(hits)), rows, others);
        const auto found = static_cast<unsigned>(__builtin_popcountll(from->bits));
        if (__builtin_expect(found > AT_ONCE, false)) {
            std::uint8_t all_hits[64];
            _mm512_storeu_si512(all_hits, hits);
            for (unsigned i = AT_ONCE; i < found; i += AT_ONCE)
                write_eight(next + i,
                            _mm_loadl_epi64(reinterpret_cast<const __m128i*>(all_hits + i)), rows,
                            others);
        }
        next += found;
    }
    room.next = next;
}

// The rows that `far` names with what is beyond the LANES after them.
[[gnu::noinline]] Hits* sweep_far(const StripRows& strip, const std::uint32_t* far,
                                  const std::uint32_t* end, Hits* hits, Hits* next,
                                  PairRoom& room) {
    for (; far < end; ++far) {
        const std::int32_t* max_x = strip.max_x + *far;
        const std::int32_t reach = strip.last_in_bucket(
            std::max(std::max(max_x[0], max_x[1]), std::max(max_x[2], max_x[3])));
        for (std::uint32_t other = *far + 1 + LANES;
             other < strip.count && strip.min_x[other] <= reach; other += LANES) {
            if (next == hits + BLOCK) {
                write(strip, hits, next, room);
                next = hits;
            }
            *next++ = compare<false>(strip, *far, other);
        }
    }
    return next;
}

void strip_rows(const StripRows& rows, PairRoom& to) {
    const StripRows strip = rows;  // copies, or each store of a vector might have changed them
    PairRoom room = to;
    Hits hits[BLOCK];
    std::uint32_t far[BLOCK + LANES];
    for (unsigned row = 0; row < strip.count; row += ROWS * BLOCK) {
        const unsigned end = std::min(strip.count, row + ROWS * BLOCK);
        Hits* next = strip.in_order(row, end) ? sweep_near<true>(strip, row, end, hits)
                                              : sweep_near<false>(strip, row, end, hits);
        next = sweep_far(strip, far, find_far(strip, row, end, far), hits, next, room);
        write(strip, hits, next, room);
    }
    to = room;
}

#endif

}  // namespace

const Kernels* avx512_kernels() {
#if defined(__AVX512VBMI2__)
    for (const bool has :
         {__builtin_cpu_supports("avx512f"), __builtin_cpu_supports("avx512vl"),
          __builtin_cpu_supports("avx512bw"), __builtin_cpu_supports("avx512vbmi2")})
        if (!has) return nullptr;
    static const Kernels KERNELS = {"AVX-512",
                                    8,
                                    avx2_kernels()->short_rows,
                                    avx2_kernels()->box_cells,
                                    avx2_kernels()->fill_rows,
                                    avx2_kernels()->packed_buckets,
                                    avx2_kernels()->packed_rows,
                                    strip_rows};
    return &KERNELS;
#else
    return nullptr;
#endif
}

}  // namespace collision
