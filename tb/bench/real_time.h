// real_time.h - simulated seconds per wall second, beside the bare Verilated model in the same run.
#pragma once

#include <string>

namespace bench {

struct Programs {
    std::string demo, demo_elf;    // a scenario and the board's program
    std::string boxes, boxes_elf;  // one that writes pixel by pixel, then polls for the swap
};

// Prints the machine's load, the speed of the bare model, and that of runs in which every frame
// becomes a PNG.  False if one is slower, relative to the bare model, than this project promises.
bool real_time(const std::string& de1sim, const std::string& out, const Programs& programs);

}  // namespace bench
