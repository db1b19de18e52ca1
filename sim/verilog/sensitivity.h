// sensitivity.h - lists of always blocks without an edge: Quartus takes all that the block reads
//
//   always @(a) y = a & b;      is logic of a and b, with warning 10235; a simulator misses b
//
// In the text that is checked, which is read with the macro DE1SIM_LISTS, the list stays.
#pragma once

#include "sim/verilog/edits.h"
#include "sim/verilog/tokens.h"

namespace sim::project {

void complete_lists(const Tokens& tokens, Edits& edits);

}  // namespace sim::project
