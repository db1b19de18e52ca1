// gates.h - tri-state gates and wired nets, which Quartus takes, as assignments.
//
//   bufif1 b (y, a, on);     becomes     assign y = (on) ? (a) : 1'bz;      bufif0, notif0, notif1
//                                                                           likewise
//   wand [3:0] w;            becomes     wire [3:0] w;
//   assign w = a;                        wire [3:0] w_de1sim_0; assign w_de1sim_0 = a;
//   assign w = b;                        wire [3:0] w_de1sim_1; assign w_de1sim_1 = b;
//                                        assign w = w_de1sim_0 & w_de1sim_1;
//
// Lines stay where they are.
//
// An assignment of a part of a wired net leaves the rest to the others.
//
// Not handled: arrays of gates; a wired net that is a port, has a value in its declaration, or is
// driven in a generate loop; a wand of which an instance drives a part.
#pragma once

#include <string>
#include <string_view>

#include "sim/verilog/instances.h"

namespace sim::project {

// `modules` says which ports of an instance are outputs.
std::string gates_as_assignments(std::string_view text, const Modules& modules);

}  // namespace sim::project
