// tri_states.h - tri-state buffers inside the chip, which has none.
//
// Where a buffer alone drives a wire that feeds logic, Quartus makes it a wire (13049), so that its
// input counts, enabled or not:
//
//   assign b = on ? a : 1'bz;      becomes      assign b = (a);
//
// Several on one wire choose among themselves, which Verilator has, too.
//
// gates.h has made bufif1 and its like such assignments.
//
// Not handled: a buffer whose wire is in another module.
#pragma once

#include "sim/verilog/edits.h"
#include "sim/verilog/instances.h"
#include "sim/verilog/quartus/message.h"

namespace sim::project {

// `modules`: as enable_part_drivers() has it.  A warning for each that is made a wire, without a
// file.
Messages join_tri_states(const Tokens& tokens, const Modules& modules, Edits& edits);

}  // namespace sim::project
