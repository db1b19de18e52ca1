// analog.h - what is wired to the board's analog inputs, as a converter in the design reads it
// through DPI (rtl/ip/de1sim_analog.vh)
//
// Only a design with such a converter has this part of the runtime.
#pragma once

namespace sim {
class PinListener;
}

// Of the design that was opened last; null: all inputs are at 0 V.
extern "C" void de1sim_set_analog(const sim::PinListener* board);
