// reorder.h - declarations that Quartus takes in any order, and Verilator in one.
//
//   module m (hit);                      module m (hit);
//       wire hit;               becomes      input hit; wire hit;
//       input hit;
//
//   defparam u.W = 4; ... defparam u.W = 8;   becomes the last one: Quartus warns and takes it
#pragma once

#include <vector>

#include "sim/verilog/edits.h"
#include "sim/verilog/items.h"
#include "sim/verilog/tokens.h"

namespace sim::project {

void reorder(const std::vector<Token>& tokens, const Items& items, Edits& edits);

}  // namespace sim::project
