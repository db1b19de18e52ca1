// cli.h - the command line of de1sim.
#pragma once

#include "sim/hps/native_cpu.h"

namespace sim {

// Parses, runs, and returns the exit code.  `firmware` is what --cpu native runs.
int main(int argc, char** argv, const Firmware& firmware);

}  // namespace sim
