// power_up.h - what registers are when the chip powers up.
//
// The registers of a Cyclone V power up at 0, and have a clear, but no preset.  Where the
// asynchronous reset makes a bit 1, Quartus inverts before and after the register ("NOT gate
// push-back"), so that it powers up at 1 as well, whatever `initial` says, and also where the reset
// never comes:
//
//   always @(posedge clk or negedge rst_n)
//       if (!rst_n) q <= 4'b1010; else q <= d;       initial q <= 4'b1010;   is added
//
// Not handled: an `initial` after the block that says otherwise, which Quartus ignores with a
// warning (18061).
#pragma once

#include <cstddef>
#include <vector>

#include "sim/verilog/tokens.h"

namespace sim::project {

// The tokens [begin, end) are a statement of an asynchronous reset, to be executed at power-up,
// too; what is written for that has its place after token `after`.
struct ResetStatement {
    std::size_t after, begin, end;
};
// In the order of `after`.
std::vector<ResetStatement> reset_statements(const std::vector<Token>& tokens);

}  // namespace sim::project
