// instance_checks.h - what Quartus refuses of a .v file's instances, by its text.
#pragma once

#include <string>

#include "sim/verilog/instances.h"
#include "sim/verilog/quartus/text_checks.h"

namespace sim::project {

// 10207: something inside an instance is named; 10663: an output of an instance is connected with a
// reg, which Quartus 24.1 takes where the module is in a library, as a Platform Designer system is.
// `name` is the file's in messages; `modules`: as enable_part_drivers() has it.
void check_instances(const std::vector<Token>& tokens, const Modules& modules,
                     const std::string& name, TextChecks& found);

}  // namespace sim::project
