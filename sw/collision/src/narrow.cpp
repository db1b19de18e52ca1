// narrow.cpp - see narrow.h
#include "narrow.h"

#include "collision/tally.h"

#if defined(__x86_64__)
#include <immintrin.h>
#endif

namespace collision {

#if defined(__x86_64__)
namespace {

#define AVX2 [[gnu::target("avx2"), gnu::always_inline]] inline

// Four lines.  A coordinate is the low half of its 64-bit lane; what is in the high half is
// ignored.
struct FourLines {
    __m256i ax, ay, bx, by;
};

AVX2 __m128i load(const Line& line) {
    return _mm_load_si128(reinterpret_cast<const __m128i*>(&line));
}

// The first four lines that have a bit in `bits`; their bits are cleared.  If there are fewer than
// four, the last one is repeated.
AVX2 FourLines next_four(const Polygon& polygon, unsigned& bits) {
    unsigned left = bits;
    const auto next = [&bits, &left] {
        const unsigned first = lowest_bit(left);
        bits = left & (left - 1);
        if (bits) left = bits;
        return first;
    };
    const auto& lines = polygon.lines;
    const __m128i line0 = load(lines[next()]), line1 = load(lines[next()]);
    const __m128i line2 = load(lines[next()]), line3 = load(lines[next()]);
    const __m256i first = _mm256_set_m128i(line1, line0), last = _mm256_set_m128i(line3, line2);
    const __m256i a = _mm256_unpacklo_epi64(first, last), b = _mm256_unpackhi_epi64(first, last);
    return {a, _mm256_srli_epi64(a, 32), b, _mm256_srli_epi64(b, 32)};
}

AVX2 FourLines broadcast(const Line& line) {
    return {_mm256_set1_epi32(line.a.x), _mm256_set1_epi32(line.a.y), _mm256_set1_epi32(line.b.x),
            _mm256_set1_epi32(line.b.y)};
}

// The sign bits of lanes where s and t are strictly on one side: both above 0, or both below.
AVX2 __m256i one_side(__m256i s, __m256i t) {
    const __m256i zero = _mm256_setzero_si256();
    return _mm256_or_si256(_mm256_and_si256(s, t),
                           _mm256_and_si256(_mm256_sub_epi64(zero, s), _mm256_sub_epi64(zero, t)));
}

// `apart`: the sign bit is set if the sides show that the lines do not meet.  `level`: all ones if
// all sides are 0; then only the boxes decide.
struct Verdict {
    __m256i apart, level;
};

// The rule of crossing.h.  Four differences of products, of which the last follows from the others:
// the difference between the sides of p's ends is minus that of q's ends.
AVX2 Verdict compare(const FourLines& p, const FourLines& q) {
    const __m256i px = _mm256_sub_epi32(p.bx, p.ax), py = _mm256_sub_epi32(p.by, p.ay);
    const __m256i qx = _mm256_sub_epi32(q.bx, q.ax), qy = _mm256_sub_epi32(q.by, q.ay);
    const __m256i ax = _mm256_sub_epi32(q.ax, p.ax), ay = _mm256_sub_epi32(q.ay, p.ay);
    const __m256i bx = _mm256_sub_epi32(q.bx, p.ax), by = _mm256_sub_epi32(q.by, p.ay);
    const __m256i qa = _mm256_sub_epi64(_mm256_mul_epi32(px, ay), _mm256_mul_epi32(py, ax));
    const __m256i qb = _mm256_sub_epi64(_mm256_mul_epi32(px, by), _mm256_mul_epi32(py, bx));
    const __m256i pa = _mm256_sub_epi64(_mm256_mul_epi32(qy, ax), _mm256_mul_epi32(qx, ay));
    const __m256i pb = _mm256_sub_epi64(pa, _mm256_sub_epi64(qb, qa));
    const __m256i any = _mm256_or_si256(_mm256_or_si256(qa, qb), _mm256_or_si256(pa, pb));
    return {_mm256_or_si256(one_side(qa, qb), one_side(pa, pb)),
            _mm256_cmpeq_epi64(any, _mm256_setzero_si256())};
}

[[gnu::target("avx2")]] bool meet_avx2(const Polygon& p, const Polygon& q) {
    const Window window{intersection(p.aabb, q.aabb)};
    const unsigned p_lines = window.reached_by(p);
    unsigned q_lines = window.reached_by(q);
    if (!p_lines || !q_lines) return false;
    __m256i all_apart = _mm256_set1_epi64x(-1), level = _mm256_setzero_si256();
    do {
        const FourLines of_q = next_four(q, q_lines);
        for (unsigned bits = p_lines; bits; bits &= bits - 1) {
            const Verdict verdict = compare(broadcast(p.lines[lowest_bit(bits)]), of_q);
            all_apart = _mm256_and_si256(all_apart, verdict.apart);
            level = _mm256_or_si256(level, verdict.level);
        }
    } while (q_lines);
    if (!_mm256_testz_si256(level, level)) {
        NoTally uncounted;
        return meet(p, q, uncounted);
    }
    return _mm256_movemask_pd(_mm256_castsi256_pd(all_apart)) != 0xf;
}

[[gnu::target("avx2")]] CollisionPair* keep_with_avx2(Polygons shapes, const CollisionPair* pairs,
                                                      std::size_t count, CollisionPair* out) {
    for (std::size_t i = 0; i < count; ++i) {
        const CollisionPair pair = pairs[i];
        *out = pair;
        out += meet_avx2(shapes[pair.first], shapes[pair.second]);
    }
    return out;
}

#undef AVX2

}  // namespace
#endif

CollisionPair* keep_meeting(Polygons shapes, const CollisionPair* pairs, std::size_t count,
                            CollisionPair* out) {
#if defined(__x86_64__)
    if (__builtin_cpu_supports("avx2")) return keep_with_avx2(shapes, pairs, count, out);
#endif
    NoTally uncounted;
    for (std::size_t i = 0; i < count; ++i) {
        const CollisionPair pair = pairs[i];
        if (meet(shapes[pair.first], shapes[pair.second], uncounted)) *out++ = pair;
    }
    return out;
}

}  // namespace collision
