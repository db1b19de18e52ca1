// vhdl_repairs.h - what GHDL 2.0 gets wrong when it writes Verilog.
//
//   the choice `when others` of a case is not written   taken from what it writes as VHDL
//   a constant of more than 32 bits is a text in quotes  becomes 36'b0101...
//   / rem mod, shifts to the right and abs of signed numbers   are written with $signed()
//   minimum and maximum are VHDL                         become a choice
//   an instance's output of the name of a signal   is that signal, where they are connected
//   a name that is a keyword of Verilog, as in `signal reg`   is escaped
#pragma once

#include <string>

namespace sim::project {

// `verilog` and `vhdl` are what GHDL writes of one design, as --out=verilog and --out=raw-vhdl.
// The latter may be empty where lacks_others() is false.
std::string repaired(const std::string& verilog, const std::string& vhdl);

bool lacks_others(const std::string& verilog);

}  // namespace sim::project
