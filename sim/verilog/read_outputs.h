// read_outputs.h - outputs that are released and read back: an open-drain SCL that is no inout
//
//   output SCL; assign SCL = low ? 1'b0 : 1'bz; wire seen = SCL;
//
// Quartus reads such a pin as 1 while it is released (13047, an OR gate).  In Verilog nothing comes
// back from outside by an output, so it becomes an inout, which the board's pull-up holds high.
//
// The same where an output is connected with an inout port of an instance.
//
// Not handled: a port that is declared in one list with others.
#pragma once

#include <string>
#include <vector>

#include "sim/verilog/edits.h"
#include "sim/verilog/instances.h"

namespace sim::project {

// Makes such outputs of `modules`, which `files` define, inouts, also of those that instance them.
void find_read_outputs(const std::vector<Tokens>& files, Modules& modules);

// The declarations of what find_read_outputs() has found.
void make_inouts(const std::vector<Token>& tokens, const Modules& modules, Edits& edits);

}  // namespace sim::project
