// released_registers.h - registers that a block releases inside the chip, which has no tri-states
//
//   always @(posedge clk) if (read) readdata <= word; else readdata <= 32'bz;
//
// Where that feeds logic, Quartus makes the buffer a wire (13049), so that it is open what is read
// while it is released: 32'bx here.
//
// Where it may reach a pin, Quartus makes a register of the value and one that enables the buffer:
//
//   reg sda;                          becomes   wire sda; reg sda__value, sda__enable;
//                                               assign sda = sda__enable ? sda__value : 1'bz;
//   sda <= ack ? 1'b0 : 1'bz;                   begin sda__value <= ack ? 1'b0 : 1'b0;
//                                               sda__enable <= ack ? 1'b1 : 1'b0; end
//
// Lines stay where they are.
//
// Not handled at a pin: a memory, and one that is assigned in braces with others.
#pragma once

#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "sim/verilog/edits.h"
#include "sim/verilog/instances.h"
#include "sim/verilog/quartus/message.h"

namespace sim::project {

// Outputs and inouts of modules that may reach a pin of the top, by module.
using PinPorts = std::map<std::string, std::set<std::string>, std::less<>>;
// Empty: the top is not among `modules`, which `files` define.
PinPorts pin_ports(const std::vector<Tokens>& files, const Modules& modules,
                   const std::string& top);

// The text with a value and an enable in place of each register that may reach a pin.
std::string with_enables(std::string_view text, const PinPorts& pins);

// A warning for each register, without a file.  Without pins nothing is changed.
Messages keep_released_registers(const std::vector<Token>& tokens, const PinPorts& pins,
                                 Edits& edits);

}  // namespace sim::project
