// drivers.h - what drives what: wires with several drivers, which Quartus refuses, and such with
// none, or that nobody reads, of which it warns.
#pragma once

#include "sim/project/quartus/netlist.h"
#include "sim/verilog/quartus/message.h"

namespace sim::project {

// 10028, 12014, 13076: two drivers of one bit; 10231: an input is assigned.  Refused is only what
// Quartus refuses for certain: memories, variables of loops and of single blocks are left alone.
Messages driver_errors(const Netlist& netlist);

// 10030, 10034, 10036, 10281, 10858, 12241, 13040, 13410, 15610.
Messages driver_warnings(const Netlist& netlist);

}  // namespace sim::project
