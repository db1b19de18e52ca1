// de1sim_analog.vh - the function by which a converter in the chip sees the board's analog inputs.
//
// To be included in a module.  The C++ side is sim/project/runtime/analog.h.
`begin_keywords "1800-2017"

// What is wired to input 0 to 7 of the board, in millivolts against ground.
import "DPI-C" function int de1sim_analog_mv(input int number);

`end_keywords
