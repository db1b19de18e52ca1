// pulled_inputs.h - inputs that are pulled, as in the files of Quartus' wizards: `tri1 clken;`
//
// For Quartus such an input is 1, or 0, where an instance leaves it open.  Verilator 5.006 holds a
// signal constant, without a word, that has pulls in two levels of modules.  So a pull of inputs
// becomes a wire, and instances connect what is 1 where it is open.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "sim/verilog/edits.h"
#include "sim/verilog/tokens.h"

namespace sim::project {

// The inputs of the file's modules that are 1 where they are open: module, port.
std::vector<std::pair<std::string, std::string>> pulled_up_inputs(const std::vector<Token>& tokens);

void make_pulled_inputs_wires(const std::vector<Token>& tokens, Edits& edits);

}  // namespace sim::project
