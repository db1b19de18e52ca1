// states.h - registers and memory that reach the edges: zeros, extremes, NaNs, denormals.
#pragma once

#include <initializer_list>

#include "tb/sim/arm_core/machine.h"
#include "tb/sim/arm_core/stream.h"

namespace tb::core {

inline std::uint32_t any_word(Random& random) {
    const auto bits = static_cast<std::uint32_t>(random());
    switch (random() % 8) {
        case 0: return 0;
        case 1: return ~0u;
        case 2: return 1u << bits % 32;
        case 3: return 0x7FFFFFFFu + bits % 3;
        case 4: return bits % 256;
        case 5: return bits & 0x80FF80FF;
        default: return bits;
    }
}

inline std::uint32_t any_single(Random& random) {
    const auto bits = static_cast<std::uint32_t>(random());
    const std::uint32_t sign = bits & 0x80000000, fraction = bits & 0x007FFFFF;
    switch (random() % 12) {
        case 0: return sign;
        case 1: return sign | 0x7F800000;
        case 2: return sign | 0x7FC00000 | fraction;
        case 3: return sign | 0x7F800001 | (fraction & 0x3FFFFF);
        case 4: return sign | fraction;                            // denormal
        case 5: return sign | (1 + bits % 30) << 23 | fraction;    // nearly
        case 6: return sign | (230 + bits % 25) << 23 | fraction;  // large
        case 7: return sign | (127 + bits % 4) << 23 | (fraction & 0x600000);
        case 8: return sign | (120 + bits % 40) << 23 | fraction;  // as integers have
        case 9: return any_word(random);
        default: return sign | (100 + bits % 54) << 23 | fraction;
    }
}

inline std::uint64_t any_double(Random& random) {
    const std::uint64_t bits = random();
    const std::uint64_t sign = bits & (1ull << 63), fraction = bits & ((1ull << 52) - 1);
    const auto exponent = [](std::uint64_t e) { return e << 52; };
    switch (random() % 10) {
        case 0: return sign;
        case 1: return sign | exponent(0x7FF);
        case 2: return sign | exponent(0x7FF) | fraction | 1ull << 51;
        case 3: return sign | exponent(0x7FF) | (fraction & ~(1ull << 51)) | 1;
        case 4: return sign | fraction;
        case 5: return sign | exponent(1 + bits % 60) | fraction;
        case 6: return sign | exponent(2000 + bits % 46) | fraction;
        case 7: return sign | exponent(1023 + bits % 4) | (fraction & 3ull << 50);
        case 8: return sign | exponent(860 + bits % 300) | fraction;  // about singles' range
        default: return sign | exponent(1000 + bits % 60) | fraction;
    }
}

inline std::uint64_t any_doubleword(Random& random) {
    switch (random() % 3) {
        case 0: return any_single(random) | std::uint64_t{any_single(random)} << 32;
        case 1: return any_double(random);
        default: return any_word(random) | std::uint64_t{any_word(random)} << 32;
    }
}

// For `stream`, with the rounding and all else of `fpscr` but its flags.
// `unaligned`: bases that should be multiples of 4 sometimes are not, and others sometimes are.
inline State any_state(Random& random, const Stream& stream, std::uint32_t fpscr, bool unaligned) {
    constexpr std::uint32_t MIDDLE = PARTS / 2 * PART;
    State state;
    for (auto& r : state.r) r = any_word(random);
    const auto place = [&] { return DATA + MIDDLE + static_cast<std::uint32_t>(random() % PART); };
    state.r[13] = place() & ~7u;
    const auto aligned = [&](std::uint32_t to) {
        return place() & ~(unaligned && random() % 2 ? 31u >> random() % 6 : to);
    };
    state.r[stream.registers.low_base] = aligned(3);
    state.r[stream.registers.low_any] = aligned(0);
    state.r[stream.registers.high_any] = aligned(0);
    state.r[stream.registers.low_index] = static_cast<std::uint32_t>(random() % 64 * 4);
    state.r[stream.registers.high_index] = static_cast<std::uint32_t>(random() % 64) << 22;
    for (auto& d : state.d) d = any_doubleword(random);
    const auto bits = static_cast<std::uint32_t>(random());
    state.cpsr = (bits & 0xF80F0000) | 0x1D3 | (stream.thumb ? 0x20 : 0);
    state.fpscr = fpscr | (bits << 1 & 0xF0000000);
    return state;
}

inline std::uint32_t any_fpscr(Random& random) {
    return random() % 3 == 0 ? 0 : static_cast<std::uint32_t>(random()) & 0x07C00000;
}

}  // namespace tb::core
