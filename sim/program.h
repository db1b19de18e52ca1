// program.h - all that the main() of a de1sim around your own firmware needs.
//
//     int main(int argc, char** argv) { return sim::program(argc, argv, my_firmware); }
//
// Free of SystemC, so that nothing else is needed to compile it.
#pragma once

#include <functional>

#include "hal/cpu.h"
#include "hal/mmio.h"

namespace sim {

// What `--cpu native` runs: for ever, or until it returns, when it is done.
using Firmware = std::function<void(hal::Mmio&, hal::Cpu&)>;

// The command line of de1sim, from the arguments to the exit code (de1sim --help); once in a
// process.
int program(int argc, char** argv, const Firmware& firmware);

// "de1sim 1.2.3", then in brackets the commit and the options that it was built with.
extern const char* const VERSION;

}  // namespace sim
