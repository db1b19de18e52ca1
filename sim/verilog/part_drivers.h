// part_drivers.h - drivers of some bits of a wire that is released, so that the other bits stay so.
//
// `assign GPIO_0[6] = x;` drives one pin.  Verilator 5.006 takes a driver without z for one of all
// bits of the wire: the other pins would read 0.  A driver that has an enable has it bit by bit.
// So each driver of a part gets one that is always on, which the C++ compiler drops again:
//
//   assign GPIO_0[6] = $c1("1") ? (x) : 'sbz;
//
// That is done with inout ports, and with what another assign of the module may release.
// An output of an instance at such a part goes through a wire and an assignment of that kind.
#pragma once

#include "sim/verilog/edits.h"
#include "sim/verilog/instances.h"
#include "sim/verilog/tokens.h"

namespace sim::project {

// `modules` are those that the file defines, and those that it instances, as far as is known.
void enable_part_drivers(const Tokens& tokens, const Modules& modules, Edits& edits);

}  // namespace sim::project
