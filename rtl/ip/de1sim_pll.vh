// de1sim_pll.vh - by which a PLL tells the simulator that it needs its reference
//
// To be included in a module.  The C++ side is sim/project/runtime/plls.h.
`begin_keywords "1800-2017"

// So many more locks count the clocks of their reference.  While none does the simulator leaves out
// the clocks of a reference that nobody else sees.
import "DPI-C" function void de1sim_pll_waits(input int more);

`end_keywords
