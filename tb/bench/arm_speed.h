// arm_speed.h - how fast the modelled Cortex-A9 is, beside the bare Verilated model.
#pragma once

#include <string>

namespace bench {

// Prints the frames a wall second of the bare model and of the whole with --cpu arm, in turn, the
// shares of its parts, and instructions a second of processor time in the program `elf` and in
// `loop`, which only computes.  Shares come from whole runs with one part less: without the PNG
// files, then without the modelled processor.  False if the whole is slower than promised.
bool arm_speed(const std::string& de1sim, const std::string& scenario, const std::string& out,
               const std::string& elf, const std::string& loop);

}  // namespace bench
