// part_drivers.h - drivers of some bits of an inout port, so that the other bits stay released.
//
// `assign GPIO_0[6] = x;` drives one pin.  Verilator 5.006 takes a driver without z for one of all
// bits of the wire: the other pins would read 0.  A driver that has an enable has it bit by bit.
// So each driver of a part gets one that is always on, which the C++ compiler drops again:
//
//   assign GPIO_0[6] = $c1("1") ? (x) : 'sbz;
//
// An output of an instance at such a part goes through a wire and an assignment of that kind.
#pragma once

#include <map>
#include <string>

#include "sim/project/edits.h"
#include "sim/project/source.h"
#include "sim/project/tokens.h"

namespace sim::project {

using Modules = std::map<std::string, ModuleText, std::less<>>;

// `modules` are those that the file defines, and those that it instances, as far as is known.
void enable_part_drivers(const Tokens& tokens, const Modules& modules, Edits& edits);

}  // namespace sim::project
