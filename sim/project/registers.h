// registers.h - which blocking assignments in a clocked block are registers' all the same.
//
//   always @(posedge clk) n = n + 1;          Quartus makes a register of n, and m gets what n was
//   always @(posedge clk) m = n;              before the edge; a simulator may do either first
//
// Where a block does not read a variable after having assigned it, "<=" means what the hardware
// does.  A variable that it does read stays as it is.
#pragma once

#include "sim/project/part_drivers.h"
#include "sim/project/tokens.h"

namespace sim::project {

// Makes "<=" of such a "=".
void make_registers(const Tokens& tokens, Edits& edits);

}  // namespace sim::project
