// chip_text.h - the ports and wires of de1sim_chip.v, from the table sim/pins/chip_wires.def.
#pragma once

#include <array>
#include <cstdint>
#include <string>

#include "sim/pins/pins.h"

namespace sim::project {

// What is between the parentheses of module de1sim_chip.
std::string chip_ports_text();

// The wires, how the board drives them, and the outputs.  `outputs`: the pins of each header that
// an output of the design drives, always.
std::string chip_wires_text(const HeaderMasks& outputs);

}  // namespace sim::project
