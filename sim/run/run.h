// run.h - one simulation from its options to its files; once per process, as SystemC wants it.
#pragma once

#include "sim/cpu/native_cpu.h"
#include "sim/run/options.h"

namespace sim {

enum ExitCode {
    PASSED = 0,
    FAILED = 1,         // an expectation missed, a firmware fault, a bus error not handled
    WRONG_INPUT = 2,    // usage, scenario, output; also an internal error of the simulator
    INTERRUPTED = 130,  // Ctrl-C; the files so far are whole
};

// Plays the scenario, or runs the program until it ends, and writes frames/, audio.wav,
// console.txt, report.json and junit.xml into options.out.  Errors go to stderr, a line each;
// progress too, unless quiet.  A run that an internal error ends leaves its report as well.
ExitCode run(const RunOptions& options, const Firmware& firmware);

}  // namespace sim
