// de1sim_hps_memory.vh - the functions by which a master in the FPGA reaches the processor's memory
// and peripherals.
//
// To be included in a module.  `port` is 0 to 5 for a command port of fpga2sdram, 6 for fpga2hps.
// The C++ side is sim/project/runtime/masters.h.
`begin_keywords "1800-2017"

// Whether the port takes a burst, or a word of one, at the next clock: it is not in reset, and the
// memory is not behind with what it has taken.
import "DPI-C" context function int de1sim_hps_takes(input int port);
// Begins a burst: `size` is the logarithm of a word's bytes, `burst` as AXI has it, `width` the
// bytes of the bus.  Returns when its first word is there, or when it is written, in picoseconds.
import "DPI-C" context function longint de1sim_hps_begin(
    input int port, input int write, input int address, input int beats, input int size,
    input int burst, input int width);
import "DPI-C" function longint de1sim_hps_time();
// The next word of the port's bursts, each byte in its lane.  Returns AXI's response.
import "DPI-C" function int de1sim_hps_read(input int port, output bit [255:0] data);
import "DPI-C" context function int de1sim_hps_write(input int port, input int strobes,
                                                     input bit [255:0] data);

`end_keywords
