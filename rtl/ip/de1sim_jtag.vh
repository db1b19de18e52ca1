// de1sim_jtag.vh - the functions by which alt_jtag_atlantic reaches the terminals on the PC.
//
// To be included in a module.  The C++ side is sim/project/runtime/jtag.h.
`begin_keywords "1800-2017"

// The number of this JTAG UART: 0, 1 ...
import "DPI-C" function int de1sim_jtag_open();
// What the PC does since it was asked last.  Bit 0: it has looked for bytes; bit 1: it sends the
// byte in bits 15:8, for which there is `room`; bit 2: it has none to send.
import "DPI-C" function int de1sim_jtag_look(input int number, input int room);
import "DPI-C" function void de1sim_jtag_sent(input int number, input int data);

`end_keywords
