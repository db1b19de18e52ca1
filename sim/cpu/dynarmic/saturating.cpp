// saturating.cpp - NEON's instructions that dynarmic does not have: VQRSHL, VQADD and VQSUB of 64
// bits, V(R)ADDHN, V(R)SUBHN, VQDMULL, VQDMLAL, VQDMLSL (ARM DDI 0406C, A8.8)
#include <cstring>
#include <limits>
#include <optional>
#include <type_traits>

#include "sim/cpu/dynarmic/instructions.h"
#include "sim/cpu/dynarmic/missed_neon.h"

namespace sim {

namespace {

unsigned size_of(std::uint32_t w) { return w >> 20 & 3; }

// The fields of an instruction, in ARM's encoding.
struct Operands {
    explicit Operands(std::uint32_t w)
        : d{number(w, 22, 12)},
          n{number(w, 7, 16)},
          m{number(w, 5, 0)},
          size{size_of(w)},
          quad{(w >> 6 & 1) != 0},
          sign{!(w >> 24 & 1)} {}
    static unsigned number(std::uint32_t w, unsigned high, unsigned low) {
        return (w >> high & 1) << 4 | (w >> low & 0xF);
    }
    unsigned d, n, m, size;
    bool quad, sign;
};

// Lanes of D registers from number `d` on.
template <class T, std::size_t N>
std::array<T, N> lanes(const VfpWords& words, unsigned d) {
    std::array<T, N> all;
    std::memcpy(all.data(), &words[2 * d], sizeof all);
    return all;
}
template <class T, std::size_t N>
void set_lanes(VfpWords& words, unsigned d, const std::array<T, N>& all) {
    std::memcpy(&words[2 * d], all.data(), sizeof all);
}

template <class T>
T limit_of(T sign_of, bool& saturated) {
    saturated = true;
    return sign_of < 0 ? std::numeric_limits<T>::min() : std::numeric_limits<T>::max();
}

template <class T>
T sum(T a, T b, bool& saturated) {
    T result;
    if (!__builtin_add_overflow(a, b, &result)) return result;
    return limit_of(a, saturated);  // of T without a sign, the largest
}
template <class T>
T difference(T a, T b, bool& saturated) {
    T result;
    if (!__builtin_sub_overflow(a, b, &result)) return result;
    if (std::is_signed_v<T>) return limit_of(a, saturated);
    saturated = true;
    return 0;
}

// To the left, or to the right with rounding where `by` is negative.
template <class T>
T shifted_with_rounding(T value, int by, bool& saturated) {
    using Limits = std::numeric_limits<T>;
    constexpr int BITS = 8 * sizeof(T);
    if (by >= 0) {
        if (value == 0) return 0;
        const bool far = by >= BITS;
        if (value > 0 && (far || value > static_cast<T>(Limits::max() >> by)))
            return limit_of(value, saturated);
        if (value < 0 && (far || value < static_cast<T>(Limits::min() >> by)))
            return limit_of(value, saturated);
        return static_cast<T>(static_cast<std::uint64_t>(value) << by);
    }
    if (-by > BITS) return 0;
    const T half = static_cast<T>(value >> (-by - 1) & 1);
    if (-by == BITS) return std::is_signed_v<T> ? 0 : half;
    return static_cast<T>((value >> -by) + half);
}

template <class Function>
void by_type(unsigned size, bool sign, Function&& function) {
    switch (size << 1 | (sign ? 0 : 1)) {
        case 0: return function(std::int8_t{});
        case 1: return function(std::uint8_t{});
        case 2: return function(std::int16_t{});
        case 3: return function(std::uint16_t{});
        case 4: return function(std::int32_t{});
        case 5: return function(std::uint32_t{});
        case 6: return function(std::int64_t{});
        default: return function(std::uint64_t{});
    }
}

template <class Function>
void of_same_length(VfpWords& words, const Operands& o, Function&& function) {
    by_type(o.size, o.sign, [&](auto zero) {
        using T = decltype(zero);
        for (unsigned i = 0; i < (o.quad ? 2u : 1u); ++i) {
            auto n = lanes<T, 8 / sizeof(T)>(words, o.n + i);
            const auto m = lanes<T, 8 / sizeof(T)>(words, o.m + i);
            for (std::size_t lane = 0; lane < n.size(); ++lane)
                n[lane] = function(n[lane], m[lane]);
            set_lanes(words, o.d + i, n);
        }
    });
}

// The upper halves of sums or differences.
void narrow(VfpWords& words, const Operands& o, bool subtract, bool round) {
    by_type(o.size + 1, false, [&](auto zero) {
        using T = decltype(zero);
        if constexpr (sizeof(T) > 1) {
            constexpr unsigned BITS = 4 * sizeof(T);
            constexpr std::size_t LANES = 16 / sizeof(T);
            const auto n = lanes<T, LANES>(words, o.n), m = lanes<T, LANES>(words, o.m);
            std::uint64_t result = 0;
            for (std::size_t lane = 0; lane < LANES; ++lane) {
                const std::uint64_t a = n[lane], b = m[lane];
                const std::uint64_t rounded =
                    (subtract ? a - b : a + b) + (round ? std::uint64_t{1} << (BITS - 1) : 0);
                const std::uint64_t half = rounded >> BITS & ((std::uint64_t{1} << BITS) - 1);
                result |= half << (BITS * lane);
            }
            set_lanes<std::uint64_t, 1>(words, o.d, {result});
        }
    });
}

enum class Product { ALONE, ADDED, SUBTRACTED };

template <class T, class Twice>
void doubling(VfpWords& words, const Operands& o, Product kind, std::optional<T> scalar,
              bool& saturated) {
    constexpr std::size_t LANES = 8 / sizeof(T);
    const auto n = lanes<T, LANES>(words, o.n), m = lanes<T, LANES>(words, o.m);
    auto d = lanes<Twice, LANES>(words, o.d);
    for (std::size_t lane = 0; lane < LANES; ++lane) {
        const Twice product = static_cast<Twice>(Twice{n[lane]} * scalar.value_or(m[lane]));
        const Twice twice = sum(product, product, saturated);
        d[lane] = kind == Product::ALONE   ? twice
                  : kind == Product::ADDED ? sum(d[lane], twice, saturated)
                                           : difference(d[lane], twice, saturated);
    }
    set_lanes(words, o.d, d);
}

template <class T, class Twice>
void doubling_with(VfpWords& words, const Operands& o, Product kind, std::uint32_t w,
                   bool& saturated) {
    std::optional<T> scalar;
    if (w >> 6 & 1) {
        const bool half = sizeof(T) == 2;
        const unsigned reg = half ? w & 7 : w & 0xF;
        const unsigned lane = half ? (w >> 4 & 2) | (w >> 3 & 1) : w >> 5 & 1;
        scalar = lanes<T, 8 / sizeof(T)>(words, reg)[lane];
    }
    doubling<T, Twice>(words, o, kind, scalar, saturated);
}

std::uint32_t in_arm(std::uint32_t w, bool thumb) {
    return thumb ? 0xF2000000 | (w >> 4 & 0x01000000) | (w & 0x00FFFFFF) : w;
}

// VQDMLAL, VQDMLSL, VQDMULL, of two registers or of one and a scalar.
bool is_doubling(std::uint32_t w) {
    if (w >> 6 & 1) return is(w, 0xFF800B50, 0xF2800340) || is(w, 0xFF800F50, 0xF2800B40);
    return is(w, 0xFF800D50, 0xF2800900) || is(w, 0xFF800F50, 0xF2800D00);
}

}  // namespace

bool is_missed_neon(std::uint32_t word, bool thumb) {
    if (thumb && !is(word, 0xEF000000, 0xEF000000)) return false;
    const std::uint32_t w = in_arm(word, thumb);
    const bool odd_d = w >> 12 & 1, odd_n = w >> 16 & 1, odd_m = w & 1;
    const bool fits = !(w >> 6 & 1) || !(odd_d || odd_n || odd_m);
    if (is(w, 0xFE800F10, 0xF2000510)) return fits;  // VQRSHL
    if (is(w, 0xFEB00F10, 0xF2300010) || is(w, 0xFEB00F10, 0xF2300210)) return fits;
    if (size_of(w) == 3) return false;
    if (is(w, 0xFE800D50, 0xF2800400)) return !odd_n && !odd_m;  // VADDHN ...
    return is_doubling(w) && size_of(w) != 0 && !odd_d;
}

bool missed_neon(std::uint32_t word, bool thumb, VfpWords& words, bool& saturated) {
    if (!is_missed_neon(word, thumb)) return false;
    const std::uint32_t w = in_arm(word, thumb), kind = w >> 8 & 0xF;
    Operands o{w};
    if (is(w, 0x00800F10, 0x00000510)) {
        of_same_length(words, o, [&](auto n, auto m) {
            return shifted_with_rounding(m, static_cast<std::int8_t>(n), saturated);
        });
    } else if (!(w >> 23 & 1)) {
        of_same_length(words, o, [&](auto n, auto m) {
            return kind == 0 ? sum(n, m, saturated) : difference(n, m, saturated);
        });
    } else if (is(w, 0x00000D40, 0x00000400)) {
        narrow(words, o, kind == 6, !o.sign);
    } else {
        const bool multiple = kind == 0xD || (kind == 0xB && (w >> 6 & 1));
        const bool added = kind == 9 || kind == 3;
        const Product product = multiple ? Product::ALONE
                                : added  ? Product::ADDED
                                         : Product::SUBTRACTED;
        if (o.size == 1)
            doubling_with<std::int16_t, std::int32_t>(words, o, product, w, saturated);
        else
            doubling_with<std::int32_t, std::int64_t>(words, o, product, w, saturated);
    }
    return true;
}

}  // namespace sim
