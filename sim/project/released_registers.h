// released_registers.h - registers that a block releases inside the chip, which has no tri-states
//
//   always @(posedge clk) if (read) readdata <= word; else readdata <= 32'bz;
//
// Where that feeds logic, Quartus makes the buffer a wire (13049), so that it is open what is read
// while it is released: 32'bx here.  What may reach a pin is left as it is.
//
// Not handled: one that may reach a pin, which Verilator refuses.
#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "sim/project/edits.h"
#include "sim/project/instances.h"
#include "sim/project/quartus/message.h"

namespace sim::project {

// Outputs and inouts of modules that may reach a pin of the top, by module.
using PinPorts = std::map<std::string, std::set<std::string>, std::less<>>;
// Empty: the top is not among `modules`, which `files` define.
PinPorts pin_ports(const std::vector<Tokens>& files, const Modules& modules,
                   const std::string& top);

// A warning for each register, without a file.  Without pins nothing is changed.
Messages keep_released_registers(const std::vector<Token>& tokens, const PinPorts& pins,
                                 Edits& edits);

}  // namespace sim::project
