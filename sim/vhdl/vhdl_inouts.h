// vhdl_inouts.h - inout ports of VHDL that are those of an instance within.
//
// GHDL has a wire between both, in one direction:
//
//   assign io = n24_o;  assign n24_o = {b_io, a_io};  pad a (.io(a_io));  pad b (.io(b_io));
//
// The wire becomes the port itself, or its bits: pad a (.io(io[2:0])).
#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

namespace sim::project {

using Inouts = std::map<std::string, std::set<std::string>>;  // ports by module

// `lines` are those of one module.
void join_inouts(std::vector<std::string>& lines, const Inouts& inouts);

}  // namespace sim::project
