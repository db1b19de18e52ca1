// run.h - one simulation from its options to its files; once per process, as SystemC wants it.
#pragma once

#include "sim/cpu/native_cpu.h"
#include "sim/run/exit_code.h"
#include "sim/run/options.h"

namespace sim {

// Plays the scenario, or runs the program until it ends, and writes frames/, audio.wav,
// console.txt, report.json and junit.xml into options.out.  Errors go to stderr, a line each;
// progress too, unless quiet.  A run that an internal error ends leaves its report as well.
ExitCode run(const RunOptions& options, const Firmware& firmware);

}  // namespace sim
