// crowd.h - how many shapes the board's program keeps moving at the full frame rate
#pragma once

#include <string>

namespace bench {

// Ten seconds of 200 X and of 250 by the ARM `elf`, after as long as it takes to put them there by
// the keypad.  Prints the new pictures and the processor's load.  False unless 200 have a new
// picture in every frame.
bool crowd(const std::string& de1sim, const std::string& folder, const std::string& elf);

}  // namespace bench
