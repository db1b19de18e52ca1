// syntax.h - what Quartus cannot read in a file: SystemVerilog in a .v file, what its
// SystemVerilog has not, and what no hardware can be.
//
// Not handled: what stands in a branch of an `ifdef, which may not be read.
#pragma once

#include <string>
#include <vector>

#include "sim/verilog/items.h"
#include "sim/verilog/quartus/text_checks.h"
#include "sim/verilog/tokens.h"

namespace sim::project {

// `name` is the file's in messages.  Of the file: 10149, 10170, 10278, 10644, 10773.  Of its
// modules, which count in the design alone: 10172, 10174, 10355; 0: the number is not known.
void find_syntax_errors(const std::vector<Token>& tokens, const Items& items,
                        const std::string& name, bool system_verilog, TextChecks& found);

}  // namespace sim::project
