// de1sim_hps_bridge.vh - the functions by which a bridge of the processor gets its bursts
//
// To be included in a module.  The C++ side is sim/project/runtime/bridge.h.
`begin_keywords "1800-2017"

// The burst that is there: posted, write, prot, cache, lock, id, burst, size, len and address, from
// bit 63 down, as AXI3 has them.
import "DPI-C" function longint de1sim_hps_burst();
// A beat of it: returns the strobes of its bytes; `address` is of the bus's word.
import "DPI-C" function int de1sim_hps_beat(input int beat, output int address,
                                            output bit [127:0] data);
// The design has answered otherwise than by OKAY: BRESP or RRESP, 1 to 3.
import "DPI-C" function void de1sim_hps_refused(input int response);
// The design has answered a beat of a read, each byte in its lane.
import "DPI-C" function void de1sim_hps_answered(input int beat, input bit [127:0] data);
// Of posted writes: the one that was there is sent (SENT), a write is answered (BVALID).  Returns
// whether others are sent and not answered.
import "DPI-C" function int de1sim_hps_posted(input bit full, input bit sent, input bit bvalid,
                                              input int bid, input int bresp);

`end_keywords
