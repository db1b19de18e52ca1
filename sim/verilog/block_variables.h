// block_variables.h - variables of a clocked block that are declared in it with a value
//
// They keep what they have from clock to clock, and the value is that at power-up, as of other
// registers.  Verilator 5.006 would set them to it at each clock.
//
//   always @(posedge clk) begin          initial de1sim_block_0.n = 0; always @(posedge clk)
//       reg [9:0] n = 0;       becomes       begin : de1sim_block_0
//                                                reg [9:0] n;
//
// Not handled: arrays with values; values that stand in a branch of an `ifdef.
#pragma once

#include <vector>

#include "sim/verilog/edits.h"
#include "sim/verilog/tokens.h"

namespace sim::project {

void begin_block_variables(const std::vector<Token>& tokens, Edits& edits);

}  // namespace sim::project
