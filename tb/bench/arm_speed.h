// arm_speed.h - the modelled Cortex-A9's share of a run's time.
#pragma once

#include <string>

namespace bench {

// Prints the shares of a run's parts, and instructions per second of processor time in the program
// `elf` and in `loop`, which only computes.  Shares are differences between whole runs: without the
// PNG files, then also without the modelled processor.
void arm_speed(const std::string& de1sim, const std::string& scenario, const std::string& out,
               const std::string& elf, const std::string& loop);

}  // namespace bench
