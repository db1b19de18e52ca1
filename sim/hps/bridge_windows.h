// bridge_windows.h - where the processor sees the FPGA: the windows of its two bridges
//
// Source: Cyclone V HPS TRM, "HPS Address Spaces".
#pragma once

#include <cstdint>

namespace sim {

constexpr std::uint32_t H2F_BASE = 0xC0000000, H2F_SIZE = 0x3C000000;  // the full bridge
constexpr std::uint32_t LW_BASE = 0xFF200000, LW_SIZE = 0x00200000;    // the lightweight bridge

}  // namespace sim
