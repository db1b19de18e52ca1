// device.h - designs that are larger than the board's chip.
//
// Not handled: logic; what Quartus leaves out since nobody reads it.
#pragma once

#include "sim/project/board_description.h"
#include "sim/project/quartus/netlist.h"
#include "sim/verilog/quartus/message.h"

namespace sim::project {

// 276003: arrays that an asynchronous reset clears are no memory, and have more bits than the chip
// has registers.  Nothing where the board's file does not say how many.
Messages register_errors(const Netlist& netlist, const BoardDescription& board);

// 170048: memories have more bits than the chip's memory blocks; likewise.
Messages memory_warnings(const Netlist& netlist, const BoardDescription& board);

}  // namespace sim::project
