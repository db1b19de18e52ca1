// fpga_places.h - the names of the FPGA's blocks and memories, for messages about accesses without
// a target
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "sim/hps/bus.h"

namespace sim {

// The registers of the register map, by address.
std::map<std::uint32_t, std::string> fpga_registers();

// The blocks and memories of the register map from `base` on, within `size` bytes.
std::vector<Bus::Place> fpga_places(std::uint32_t base, std::uint32_t size);

}  // namespace sim
