// header_bits.h - JP1's and JP2's D31-D0 among the 36 pins of a header
//
//   bit  31:15   14   13:1   0       as rtl/board/de1_soc/header.v wires them; D31-D0 are what
//   pin  35:19   17   15:3   1       the DE1-SoC Computer's parallel ports have
#pragma once

#include <cstdint>

namespace sim {

constexpr std::uint64_t ALL_HEADER_PINS = (std::uint64_t{1} << 36) - 1;

constexpr std::uint32_t bits_of_pins(std::uint64_t pins) {
    return static_cast<std::uint32_t>((pins >> 1 & 1) | (pins >> 3 & 0x1fff) << 1 |
                                      (pins >> 17 & 1) << 14 | (pins >> 19 & 0x1ffff) << 15);
}

constexpr std::uint64_t pins_of_bits(std::uint64_t bits) {
    return (bits & 1) << 1 | (bits >> 1 & 0x1fff) << 3 | (bits >> 14 & 1) << 17 |
           (bits >> 15 & 0x1ffff) << 19;
}

}  // namespace sim
