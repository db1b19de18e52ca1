// registers.h - blocking assignments in clocked blocks, as the registers that Quartus makes
//
//   always @(posedge clk) n = n + 1;          Quartus makes a register of n, and m gets what n was
//   always @(posedge clk) m = n;              before the edge; a simulator may do either first
//
// Where a block does not read a variable after having assigned it, "<=" means what the hardware
// does.  Where it does, and other blocks or the module's ports have the variable too, or the block
// also assigns it by "<=" (Verilator 5.006 loses the "=" then), it gets a copy for its own reads:
//
//   always @(posedge clk) begin              always @(posedge clk) begin : b reg [3:0] d; d = n;
//       n = n + 1;                  becomes      begin d = d + 1; n <= d; end
//       if (n == 10) n <= 0;                     if (d == 10) n <= 0;
//
// A block that calls tasks, which may have the variable as well, gets no copy: where it also
// assigns n by "<=", its "n = d;" becomes "n = d; n <= n;".
//
// Not handled: the others of a block that calls tasks; memories that a block reads after it has
// assigned them.
#pragma once

#include "sim/verilog/part_drivers.h"
#include "sim/verilog/tokens.h"

namespace sim::project {

void make_registers(const Tokens& tokens, Edits& edits);

}  // namespace sim::project
