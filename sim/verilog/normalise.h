// normalise.h - Verilog as Quartus takes it, made into what the standard and Verilator take.
//
// Changed, each with a line that says so:
//   an instance without a name               gets one
//   a literal with more digits than its size  loses the leading ones, as in Quartus
//   a comma before a closing parenthesis      goes
//   declarations in an order that Verilator does not take  see reorder.h
//   a type that several parameters share        is repeated, see parameter_types.h
//   concurrent assertions                       go, see assertions.h
//   a .v file with words of SystemVerilog as names  is read with the keywords of Verilog-2005
//
// Not noted: a comment that Verilator would take for an order to itself, inputs that are 1 where
// they are open, of models and of pulled_inputs.h, the enables of part_drivers.h, the calls of
// init_text.h, the registers of registers.h, the resets of power_up.h, the lists of sensitivity.h,
// and the names "small", "medium" and "large", which are escaped.  A warning is given of the wires
// of tri_states.h and the registers of released_registers.h.
//
// Lines stay where they are, and messages name the original file.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "sim/verilog/init_text.h"
#include "sim/verilog/inout_fits.h"
#include "sim/verilog/part_drivers.h"
#include "sim/verilog/quartus/text_checks.h"
#include "sim/verilog/released_registers.h"

namespace sim::project {

struct Normalised {
    std::string text;
    std::vector<std::string> changes;  // "pong.v:12: named the instance of ball"
    std::vector<InitName> init_names;
    TextChecks checks;
};

// Inputs that are 1 where a design leaves them open, of models of Intel's IP and of its own
// modules: module, port.
using OpenInputs = std::multimap<std::string, std::string, std::less<>>;
OpenInputs read_open_inputs(const std::filesystem::path& table);  // rtl/ip/defaults.tsv

// `name` is the file's in messages; `system_verilog`: it is read as such, keywords and all;
// `modules`: as enable_part_drivers() has it.
Normalised normalise(std::string_view text, const std::string& name, bool system_verilog,
                     const OpenInputs& open_inputs = {}, const Modules& modules = {},
                     const std::vector<InoutFit>& inout_fits = {}, const PinPorts& pins = {});

}  // namespace sim::project
