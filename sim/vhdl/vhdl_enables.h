// vhdl_enables.h - pins that VHDL releases, as Verilator takes them.
//
// GHDL lets a 'Z' pass through wires, choices and registers up to a port.  Verilator sees an enable
// only in the expression that drives a pin.  So what may be 'Z' gets a twin that says bit by bit
// whether it is driven, through all that it passes:
//
//   n6_o = oe ? d : 4'bZ;                n6_o = oe ? d : 4'b0;    n6_o__on = oe ? 4'b1 : 4'b0;
//   n9_q <= n6_o;            becomes     n9_q <= n6_o;            n9_q__on <= n6_o__on;
//   io = n9_q;                           io = {n9_q__on[3] ? n9_q[3] : 1'bZ, ...};
//
// Not handled: a 'Z' that an operation takes, as in a & b, counts as 0.
#pragma once

#include <string>
#include <vector>

namespace sim::project {

// The text of the module that `lines` are.
std::string with_enables(const std::vector<std::string>& lines);

}  // namespace sim::project
