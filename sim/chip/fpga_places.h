// fpga_places.h - the FPGA's blocks and memories in words, for accesses that nothing answers
#pragma once

#include <cstdint>
#include <vector>

#include "sim/hps/bus.h"

namespace sim {

// Those of the register map from `base` on, within `size` bytes.
std::vector<Bus::Place> fpga_places(std::uint32_t base, std::uint32_t size);

}  // namespace sim
