// fpga_places.h - the names of the FPGA's blocks and memories, for messages about accesses without
// a target
#pragma once

#include <cstdint>
#include <vector>

#include "sim/hps/bus.h"

namespace sim {

// Those of the register map from `base` on, within `size` bytes.
std::vector<Bus::Place> fpga_places(std::uint32_t base, std::uint32_t size);

}  // namespace sim
