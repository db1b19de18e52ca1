// device.h - designs that are larger than the board's chip, the 5CSEMA5F31C6.
//
// Not handled: logic; what Quartus leaves out since nobody reads it.
#pragma once

#include "sim/project/quartus/netlist.h"
#include "sim/verilog/quartus/message.h"

namespace sim::project {

// 276003: arrays that an asynchronous reset clears are no memory, and have more bits than the chip
// has registers, 128,280.
Messages register_errors(const Netlist& netlist);

// 170048: memories have more bits than the chip's 397 M10K, 4,065,280.
Messages memory_warnings(const Netlist& netlist);

}  // namespace sim::project
