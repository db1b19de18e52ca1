// fpu.h - single-precision arithmetic of RISC-V's F: values, rounding and flags exact
//
// A result is computed as a double that stands for the exact one: where that lies between two
// doubles, the one of the two whose last bit is 1.  A double has more than two bits over a float,
// so rounding it once more, in any mode, gives what rounding the exact value would.  So the host's
// rounding mode and flags are left alone.
//
// Style::NIOS_V: operands and results of additions, multiplications, divisions, roots and
// comparisons that are subnormal are 0, and a fused operation rounds its product first.
//
// Source: The RISC-V Instruction Set Manual, volume I, 20191213, chapter 11; of the style the
// Nios V Processor Reference Manual, "Floating Point Operations".
//
// Not handled: which flags the vendor's unit sets for what it replaces by 0; its root, which is
// faithful, is rounded correctly.
#pragma once

#include <cmath>
#include <cstdint>
#include <cstring>

namespace sim {

class RiscvFpu {
public:
    enum class Style { IEEE, NIOS_V };
    enum Rounding : unsigned { NEAREST = 0, TO_ZERO = 1, DOWN = 2, UP = 3, TIES_AWAY = 4 };
    enum Flag : std::uint32_t {
        INEXACT = 1,
        UNDERFLOW_ = 2,
        OVERFLOW_ = 4,
        BY_ZERO = 8,
        INVALID = 16
    };

    explicit RiscvFpu(Style style) : flushes_{style == Style::NIOS_V} {}

    std::uint32_t flags = 0;

    // Bits of floats; `rounding` is one of the five.
    std::uint32_t add(std::uint32_t a, std::uint32_t b, unsigned rounding) {
        return quick(of(a) + of(b), rounding, [&] { return exact_add(a, b, rounding); });
    }
    std::uint32_t subtract(std::uint32_t a, std::uint32_t b, unsigned rounding) {
        return quick(of(a) - of(b), rounding, [&] { return exact_add(a, b ^ SIGN, rounding); });
    }
    std::uint32_t multiply(std::uint32_t a, std::uint32_t b, unsigned rounding) {
        return quick(of(a) * of(b), rounding, [&] { return exact_multiply(a, b, rounding); });
    }
    std::uint32_t divide(std::uint32_t a, std::uint32_t b, unsigned rounding);
    std::uint32_t root(std::uint32_t a, unsigned rounding);
    // a * b + c
    std::uint32_t fused(std::uint32_t a, std::uint32_t b, std::uint32_t c, unsigned rounding);

    std::uint32_t lower(std::uint32_t a, std::uint32_t b);
    std::uint32_t higher(std::uint32_t a, std::uint32_t b);
    bool equal(std::uint32_t a, std::uint32_t b);
    bool less(std::uint32_t a, std::uint32_t b);
    bool less_or_equal(std::uint32_t a, std::uint32_t b);
    static std::uint32_t classify(std::uint32_t a);

    std::uint32_t to_int(std::uint32_t a, bool is_signed, unsigned rounding);
    std::uint32_t from_int(std::uint32_t value, bool is_signed, unsigned rounding);

private:
    static constexpr std::uint32_t SIGN = 0x80000000, NAN_ = 0x7FC00000;

    static float of(std::uint32_t bits) {
        float value;
        std::memcpy(&value, &bits, sizeof value);
        return value;
    }
    static std::uint32_t bits_of(float value) {
        std::uint32_t bits;
        std::memcpy(&bits, &value, sizeof bits);
        return bits;
    }
    static bool is_nan(std::uint32_t a) { return (a & ~SIGN) > 0x7F800000; }
    static bool is_signalling(std::uint32_t a) { return is_nan(a) && !(a & 0x00400000); }

    // The host's own result, where it is right and no flag can be new.
    template <class Exact>
    std::uint32_t quick(float result, unsigned rounding, Exact exact) {
        const std::uint32_t bits = bits_of(result), exponent = bits >> 23 & 0xFF;
        const bool plain = exponent > 1 && exponent < 0xFE;
        return (flags & INEXACT) && rounding == NEAREST && plain && !flushes_ ? bits : exact();
    }
    std::uint32_t exact_add(std::uint32_t a, std::uint32_t b, unsigned rounding);
    std::uint32_t exact_multiply(std::uint32_t a, std::uint32_t b, unsigned rounding);
    std::uint32_t add_to(double product, std::uint32_t c, unsigned rounding);
    std::uint32_t invalid();
    std::uint32_t quiet(std::uint32_t a, std::uint32_t b = 0, std::uint32_t c = 0);
    bool compared(std::uint32_t& a, std::uint32_t& b, bool signals);
    std::uint32_t flushed(std::uint32_t a) const {
        return flushes_ && (a & 0x7F800000) == 0 ? a & SIGN : a;
    }
    std::uint32_t rounded(double exact, unsigned rounding);

    const bool flushes_;
};

}  // namespace sim
