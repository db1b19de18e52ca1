// jtag.h - the terminals on the PC, as the design's alt_jtag_atlantic reach them through DPI
// (rtl/ip/de1sim_jtag.vh)
//
// The PC looks every millisecond, a frame of full-speed USB, and sends a byte then.
#pragma once

#include "sim/project/model.h"

namespace sim::project {

// Those of the design that is opened next; null: nobody types, and what is sent is lost.  Holds for
// all models of the process: a DPI function has no other context.
void set_jtag_terminals(JtagTerminals* terminals);

}  // namespace sim::project
