// crowd.h - how many shapes the board's program keeps moving at the full frame rate
#pragma once

#include <string>

namespace bench {

// Runs the ARM `elf` for ten seconds with 200 X and with 250, after creating them by the keypad.
// Prints the number of new pictures and the processor's load.  False unless the run with 200 has a
// new picture in every frame.
bool crowd(const std::string& de1sim, const std::string& folder, const std::string& elf);

}  // namespace bench
