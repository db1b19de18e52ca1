// de1sim_hps_wires.vh - the functions by which the processor's peripherals have signals in a design
//
// To be included in a module.  The C++ side is sim/project/runtime/peripherals.h.
`begin_keywords "1800-2017"

// The design has this peripheral, to which these levels go at first.  Returns a handle, from 1 on.
import "DPI-C" context function int de1sim_hps_peripheral(input int kind, input int number,
                                                          input longint idle);
// The levels that the design gives it.
import "DPI-C" function void de1sim_hps_signals(input int peripheral, input longint levels);
// The levels that it gives the design.
import "DPI-C" function longint de1sim_hps_levels(input int peripheral);

`end_keywords
