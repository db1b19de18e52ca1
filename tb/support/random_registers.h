// random_registers.h - registers without a reset start with random values, so that a missing reset
// shows.
#pragma once

#include <verilated.h>

namespace tb {

// Call before the first model is made (SetUpTestSuite).  Works on modules Verilated with
// --x-initial unique.
inline void start_with_random_registers() {
    Verilated::randReset(2);
    Verilated::randSeed(1);
}

}  // namespace tb
