// plls.h - what PLLs of the design tell: their clocks' times, and whether a lock waits.
#pragma once

#include "sim/project/runtime/clocks.h"

namespace sim::project {

extern Clocks* clocks_of_design;  // of the one that is evaluated; or null
extern int pll_locks_waiting;     // that count the clocks of their reference (de1sim_pll_lock.v)

}  // namespace sim::project
