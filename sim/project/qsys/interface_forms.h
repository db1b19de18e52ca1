// interface_forms.h - interfaces that a description has in another form than the generator
#pragma once

#include <vector>

#include "sim/project/qsys/component.h"

namespace sim::project::qsys {

// An APB slave has the signals of an Avalon one with a clock of setup, and two more: penable, which
// is read or write, and pwrite, which is there in the setup too.
void make_apb_avalon(std::vector<Interface>& interfaces);

// A clock that has a reset among its ports, as before Quartus 10, stands for two interfaces: NAME
// and NAME_reset, which resets all that has this clock.
void part_resets(std::vector<Interface>& interfaces);

}  // namespace sim::project::qsys
