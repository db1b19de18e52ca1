// pins.h - what Quartus says of the pins that the settings assign to the top's ports.
#pragma once

#include <vector>

#include "sim/project/elaborated.h"
#include "sim/project/project.h"
#include "sim/verilog/quartus/message.h"

namespace sim::project {

// 171016: the pin is none for the FPGA's signals; 176310: two ports are on one.
Messages pin_errors(const Project& project, const std::vector<Port>& ports);

// 15706, 169085; 171016: the board has nothing at that pin.  Nothing where there are no settings.
Messages pin_warnings(const Project& project, const std::vector<Port>& ports);

}  // namespace sim::project
