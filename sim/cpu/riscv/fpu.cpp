#include "sim/cpu/riscv/fpu.h"

#include <algorithm>

namespace sim {

namespace {

std::uint64_t bits_of_double(double value) {
    std::uint64_t bits;
    std::memcpy(&bits, &value, sizeof bits);
    return bits;
}

double double_of(std::uint64_t bits) {
    double value;
    std::memcpy(&value, &bits, sizeof value);
    return value;
}

// Stands for near + rest, of which `near` is the nearest double: only the sign of `rest` counts.
double odd(double near, double rest) {
    const std::uint64_t bits = bits_of_double(near);
    if (rest == 0 || (bits & 1)) return near;
    return double_of((rest > 0) == (near > 0) ? bits + 1 : bits - 1);
}

// Whether a magnitude is rounded up, whose bits below the last one are `rest` of `unit`.
bool rounds_up(bool negative, bool last, std::uint64_t rest, std::uint64_t unit,
               unsigned rounding) {
    if (rest == 0) return false;
    const std::uint64_t half = unit / 2;
    switch (rounding) {
        case RiscvFpu::NEAREST: return rest > half || (rest == half && last);
        case RiscvFpu::TIES_AWAY: return rest >= half;
        case RiscvFpu::DOWN: return negative;
        case RiscvFpu::UP: return !negative;
        default: return false;
    }
}

}  // namespace

std::uint32_t RiscvFpu::rounded(double exact, unsigned rounding) {
    constexpr int LOWEST = -126, HIGHEST = 127, BELOW = 52 - 23;  // exponents; bits below a float's
    const std::uint64_t all = bits_of_double(exact);
    const bool negative = all >> 63;
    const std::uint32_t sign = negative ? SIGN : 0;
    if (exact == 0) return sign;
    const int exponent = static_cast<int>(all >> 52 & 0x7FF) - 1023;
    const std::uint64_t magnitude = (all & ((std::uint64_t{1} << 52) - 1)) | std::uint64_t{1} << 52;
    const auto at = [&](int below) {  // without that many bits
        const std::uint64_t unit = std::uint64_t{1} << below, kept = magnitude >> below;
        const std::uint64_t rest = magnitude & (unit - 1);
        return kept + rounds_up(negative, kept & 1, rest, unit, rounding);
    };
    const int below = std::min(BELOW + std::max(0, LOWEST - exponent), 60);
    const bool inexact = magnitude & ((std::uint64_t{1} << below) - 1);
    const std::uint64_t kept = at(below);
    std::uint32_t result;
    if (exponent < LOWEST) {
        const bool tiny = exponent < LOWEST - 1 || at(BELOW) >> 24 == 0;
        if (tiny && inexact) flags |= UNDERFLOW_;
        result = static_cast<std::uint32_t>(kept);
    } else {
        result =
            static_cast<std::uint32_t>(kept + (static_cast<std::uint64_t>(exponent + 126) << 23));
        if (exponent > HIGHEST || result >= 0x7F800000) {
            flags |= OVERFLOW_ | INEXACT;
            const bool to_infinity =
                rounding == NEAREST || rounding == TIES_AWAY || rounding == (negative ? DOWN : UP);
            return sign | (to_infinity ? 0x7F800000 : 0x7F7FFFFF);
        }
    }
    if (inexact) flags |= INEXACT;
    return sign | result;
}

std::uint32_t RiscvFpu::invalid() {
    flags |= INVALID;
    return NAN_;
}

// The result where an operand is no number.
std::uint32_t RiscvFpu::quiet(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    if (is_signalling(a) || is_signalling(b) || is_signalling(c)) flags |= INVALID;
    return NAN_;
}

// `product` is exact, or infinite.
std::uint32_t RiscvFpu::add_to(double product, std::uint32_t c, unsigned rounding) {
    const double other = of(c), sum = product + other;
    if (std::isnan(sum)) return invalid();
    if (std::isinf(sum)) return bits_of(static_cast<float>(sum));
    if (sum == 0 && std::signbit(product) != std::signbit(other))
        return rounding == DOWN ? SIGN : 0;
    const double part = sum - product;
    return flushed(rounded(odd(sum, (product - (sum - part)) + (other - part)), rounding));
}

std::uint32_t RiscvFpu::exact_add(std::uint32_t a, std::uint32_t b, unsigned rounding) {
    a = flushed(a), b = flushed(b);
    if (is_nan(a) || is_nan(b)) return quiet(a, b);
    return add_to(of(a), b, rounding);
}

std::uint32_t RiscvFpu::exact_multiply(std::uint32_t a, std::uint32_t b, unsigned rounding) {
    a = flushed(a), b = flushed(b);
    if (is_nan(a) || is_nan(b)) return quiet(a, b);
    const double product = double{of(a)} * of(b);
    if (std::isnan(product)) return invalid();
    if (std::isinf(product)) return bits_of(static_cast<float>(product));
    return flushed(rounded(product, rounding));
}

std::uint32_t RiscvFpu::fused(std::uint32_t a, std::uint32_t b, std::uint32_t c,
                              unsigned rounding) {
    if (flushes_) return exact_add(exact_multiply(a, b, rounding), c, rounding);
    const double product = double{of(a)} * of(b);
    if (std::isnan(product) && !is_nan(a) && !is_nan(b)) return invalid();
    if (is_nan(a) || is_nan(b) || is_nan(c)) return quiet(a, b, c);
    return add_to(product, c, rounding);
}

std::uint32_t RiscvFpu::divide(std::uint32_t a, std::uint32_t b, unsigned rounding) {
    a = flushed(a), b = flushed(b);
    if (is_nan(a) || is_nan(b)) return quiet(a, b);
    const double above = of(a), below = of(b), quotient = above / below;
    if (std::isnan(quotient)) return invalid();
    if (below == 0 && !std::isinf(above)) flags |= BY_ZERO;
    if (std::isinf(quotient)) return bits_of(static_cast<float>(quotient));
    if (std::isinf(below)) return std::signbit(quotient) ? SIGN : 0;
    const double rest = std::fma(-quotient, below, above);
    return flushed(rounded(odd(quotient, below > 0 ? rest : -rest), rounding));
}

std::uint32_t RiscvFpu::root(std::uint32_t a, unsigned rounding) {
    a = flushed(a);
    if (is_nan(a)) return quiet(a);
    const double value = of(a);
    if (value == 0) return a;
    if (value < 0) return invalid();
    if (std::isinf(value)) return a;
    const double root = std::sqrt(value);
    return rounded(odd(root, std::fma(-root, root, value)), rounding);
}

std::uint32_t RiscvFpu::lower(std::uint32_t a, std::uint32_t b) {
    if (is_signalling(a) || is_signalling(b)) flags |= INVALID;
    if (is_nan(a)) return is_nan(b) ? NAN_ : b;
    if (is_nan(b)) return a;
    if (of(a) == of(b)) return a | b;  // 0 and -0
    return of(a) < of(b) ? a : b;
}

std::uint32_t RiscvFpu::higher(std::uint32_t a, std::uint32_t b) {
    if (is_signalling(a) || is_signalling(b)) flags |= INVALID;
    if (is_nan(a)) return is_nan(b) ? NAN_ : b;
    if (is_nan(b)) return a;
    if (of(a) == of(b)) return a & b;
    return of(a) > of(b) ? a : b;
}

// Whether both are numbers; `signals`: otherwise that is invalid.
bool RiscvFpu::compared(std::uint32_t& a, std::uint32_t& b, bool signals) {
    a = flushed(a), b = flushed(b);
    if (!is_nan(a) && !is_nan(b)) return true;
    if (signals || is_signalling(a) || is_signalling(b)) flags |= INVALID;
    return false;
}

bool RiscvFpu::equal(std::uint32_t a, std::uint32_t b) {
    return compared(a, b, false) && of(a) == of(b);
}

bool RiscvFpu::less(std::uint32_t a, std::uint32_t b) {
    return compared(a, b, true) && of(a) < of(b);
}

bool RiscvFpu::less_or_equal(std::uint32_t a, std::uint32_t b) {
    return compared(a, b, true) && of(a) <= of(b);
}

std::uint32_t RiscvFpu::classify(std::uint32_t a) {
    const bool negative = a & SIGN;
    const std::uint32_t magnitude = a & ~SIGN;
    if (is_nan(a)) return is_signalling(a) ? 1u << 8 : 1u << 9;
    const unsigned kind = magnitude == 0x7F800000   ? 0  // infinite
                          : magnitude >= 0x00800000 ? 1  // normal
                          : magnitude != 0          ? 2  // subnormal
                                                    : 3;          // 0
    return negative ? 1u << kind : 1u << (7 - kind);
}

std::uint32_t RiscvFpu::to_int(std::uint32_t a, bool is_signed, unsigned rounding) {
    const double lowest = is_signed ? -2147483648.0 : 0.0;
    const double highest = is_signed ? 2147483647.0 : 4294967295.0;
    const std::uint32_t most = is_signed ? 0x7FFFFFFF : 0xFFFFFFFF;
    if (is_nan(a)) return invalid(), most;
    const double value = of(a);
    double whole;
    switch (rounding) {
        case NEAREST: whole = std::nearbyint(value); break;  // the host's mode is this one
        case DOWN: whole = std::floor(value); break;
        case UP: whole = std::ceil(value); break;
        case TIES_AWAY: whole = std::round(value); break;
        default: whole = std::trunc(value); break;
    }
    if (whole < lowest) return invalid(), is_signed ? 0x80000000 : 0;
    if (whole > highest) return invalid(), most;
    if (whole != value) flags |= INEXACT;
    return static_cast<std::uint32_t>(static_cast<std::int64_t>(whole));
}

std::uint32_t RiscvFpu::from_int(std::uint32_t value, bool is_signed, unsigned rounding) {
    const double exact = is_signed ? static_cast<std::int32_t>(value) : static_cast<double>(value);
    return rounded(exact, rounding);
}

}  // namespace sim
