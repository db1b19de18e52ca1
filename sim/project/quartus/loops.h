// loops.h - loops that Quartus does not unroll.
#pragma once

#include "sim/project/quartus/message.h"
#include "sim/project/quartus/netlist.h"

namespace sim::project {

// 10106: a loop of more than 5,000 rounds; 10119: how many it has depends on a signal, and may be
// more than 250.
//
// Not handled: VERILOG_CONSTANT_LOOP_LIMIT and VERILOG_NON_CONSTANT_LOOP_LIMIT; loops of functions
// and tasks; what is told neither by a counter nor by a variable that counts itself.
Messages loop_errors(const Netlist& netlist);

}  // namespace sim::project
