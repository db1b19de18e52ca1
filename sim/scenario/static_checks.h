// static_checks.h - mistakes that can be seen before the run
#pragma once

#include "sim/scenario/scenario.h"

namespace sim {

// Throws Refusal for: holding or pressing what is held already, releasing what is not held, two
// screenshots of one name, one where a file of the run or another screenshot has to be, and steps
// that the duration leaves no time for.
void check_steps(const Scenario& scenario);

}  // namespace sim
