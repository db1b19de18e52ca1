// sine.h - sine and cosine from a table of integers: 1024 steps per turn, exactly symmetric.
#pragma once

#include <array>
#include <cstdint>

namespace app {

using Angle = std::uint32_t;  // 2^32 per turn, so that sums wrap by themselves

constexpr Angle QUARTER_TURN = Angle{1} << 30;
constexpr std::int32_t SINE_ONE = 65536;

// sin(step * turn / 1024) * SINE_ONE for steps 0 to 256, by the Taylor series in 2.30 fixed point.
constexpr std::array<std::int32_t, 257> quarter_sine() {
    constexpr std::int64_t PI = 0x3243f6a8885a308d;  // * 2^60
    std::array<std::int32_t, 257> table{};
    for (unsigned step = 0; step <= 256; ++step) {
        const std::int64_t x = PI / 512 * step >> 30, square = x * x >> 30;
        std::int64_t term = x, sum = x;
        for (int k = 2; k < 18; k += 2) {
            term = -(term * square >> 30) / (k * (k + 1));
            sum += term;
        }
        table[step] = static_cast<std::int32_t>((sum + (1 << 13)) >> 14);
    }
    return table;
}

inline constexpr std::array<std::int32_t, 257> QUARTER_SINE = quarter_sine();

constexpr std::int32_t sine(Angle angle) {
    const unsigned step = angle >> 22, within = step & 255;
    const std::int32_t size = QUARTER_SINE[step & 256 ? 256 - within : within];
    return step & 512 ? -size : size;
}

constexpr std::int32_t cosine(Angle angle) { return sine(angle + QUARTER_TURN); }

}  // namespace app
