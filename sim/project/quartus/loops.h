// loops.h - loops that Quartus does not unroll.
#pragma once

#include "sim/project/project.h"
#include "sim/project/quartus/netlist.h"
#include "sim/verilog/quartus/message.h"

namespace sim::project {

// 10106: a loop of more rounds than `constant`; 10119: how many it has depends on a signal, and may
// be more than `non_constant`.
//
// Not handled: loops of functions and tasks; rounds that neither a counter nor a variable that
// counts itself determines.
Messages loop_errors(const Netlist& netlist, const LoopLimits& limits);

}  // namespace sim::project
