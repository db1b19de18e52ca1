// colour.h - a pixel as the picture memory holds it: RGB565.
#pragma once

#include <cstdint>

namespace gfx {

using Colour = std::uint16_t;  // red in 15:11, green in 10:5, blue in 4:0

// Channels from 0 to 255; the low bits that do not fit are dropped.
constexpr Colour rgb(unsigned red, unsigned green, unsigned blue) {
    return static_cast<Colour>((red & 0xf8u) << 8 | (green & 0xfcu) << 3 | (blue & 0xf8u) >> 3);
}

constexpr Colour BLACK = 0, WHITE = 0xffff;

}  // namespace gfx
