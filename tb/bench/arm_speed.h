// arm_speed.h - what the modelled Cortex-A9 takes of a run.
#pragma once

#include <string>

namespace bench {

// Prints the shares of a run's parts, and instructions per second of processor time in the program
// `elf` and in `loop`, which only computes.  Shares come from whole runs with one part less:
// without the PNG files, then without the modelled processor.
void arm_speed(const std::string& de1sim, const std::string& scenario, const std::string& out,
               const std::string& elf, const std::string& loop);

}  // namespace bench
