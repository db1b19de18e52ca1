// steps.cpp - VRECPS and VRSQRTS, which ARMv7 rounds twice (ARM DDI 0406C, A2.7.7), dynarmic once.
#include <array>
#include <cmath>
#include <cstring>
#include <limits>

#include "sim/cpu/dynarmic/missed_neon.h"

namespace sim {

namespace {

// NEON ignores FPSCR: denormal numbers are zeros, there is one NaN, rounding is to the nearest.
float flushed(double value) {
    constexpr double LEAST = std::numeric_limits<float>::min();
    return static_cast<float>(std::abs(value) < LEAST ? std::copysign(0.0, value) : value);
}

float reciprocal_step(float a, float b, bool square_root) {
    a = flushed(a);
    b = flushed(b);
    if (std::isnan(a) || std::isnan(b)) return std::numeric_limits<float>::quiet_NaN();
    const bool no_product = (std::isinf(a) && b == 0) || (a == 0 && std::isinf(b));
    const float product = no_product ? 0 : flushed(static_cast<double>(a) * b);
    return square_root ? (3 - product) / 2 : 2 - product;
}

}  // namespace

bool newton_step(std::uint32_t w, VfpWords& words) {
    const auto number = [w](unsigned high, unsigned low) {
        return (w >> high & 1) << 4 | (w >> low & 0xF);
    };
    const unsigned d = number(22, 12), n = number(7, 16), m = number(5, 0);
    const bool quad = w >> 6 & 1, square_root = w >> 21 & 1;
    if (quad && ((d | n | m) & 1)) return false;
    std::array<std::uint32_t, 4> results{};
    const unsigned lanes = quad ? 4 : 2;
    for (unsigned i = 0; i < lanes; ++i) {
        float a, b;
        std::memcpy(&a, &words[2 * n + i], sizeof a);
        std::memcpy(&b, &words[2 * m + i], sizeof b);
        const float result = reciprocal_step(a, b, square_root);
        std::memcpy(&results[i], &result, sizeof result);
    }
    for (unsigned i = 0; i < lanes; ++i) words[2 * d + i] = results[i];
    return true;
}

}  // namespace sim
