// parameter_types.h - the type of a parameter in a module's header, for those that follow it.
//
//   module m #(parameter signed [8:0] A = 1, B = 2)
//   becomes #(parameter signed [8:0] A = 1, parameter signed [8:0] B = 2)
//
// By the standard a type is that of all names up to the next one.  Verilator 5.006 forgets it for B
// where an instance gives B a value, but not in a declaration of the module's body.
#pragma once

#include <vector>

#include "sim/verilog/edits.h"
#include "sim/verilog/tokens.h"

namespace sim::project {

void repeat_parameter_types(const std::vector<Token>& tokens, Edits& edits);

}  // namespace sim::project
