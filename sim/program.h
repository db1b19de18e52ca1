// program.h - all that the main() of a de1sim around your own firmware needs.
//
//     int main(int argc, char** argv) { return sim::program(argc, argv, my_firmware); }
//
// Free of SystemC, so that nothing else is needed to compile it.
#pragma once

#include "sim/cpu/firmware.h"

namespace sim {

// The command line of de1sim, from the arguments to the exit code (de1sim --help); once in a
// process.
int program(int argc, char** argv, const Firmware& firmware);

}  // namespace sim
