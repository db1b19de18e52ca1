// power_up.h - what is 1 when the chip powers up has not risen.
//
// Verilator 5.006 remembers what a signal was for `always @(posedge x)` before the design has
// settled for the first time.  A signal that settles at 1 then counts as an edge, which no register
// of the board sees.
#pragma once

#include <filesystem>

namespace sim::project {

// Lets the Verilated design in `objects` remember once more, when it has settled.
void forget_edges_of_power_up(const std::filesystem::path& objects);

}  // namespace sim::project
