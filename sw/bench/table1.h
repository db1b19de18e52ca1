// table1.h - the paper's table on the processor that this runs on: no operating system, no files.
#pragma once

#include "hal/cpu.h"

namespace bench {

// Prints a line a cell, "square,100,simd,12345": shape, shapes inserted, algorithm, nanoseconds a
// tick for the pairs alone; "table1 done" at last.  16-pixel shapes as in workload.h.  A cell is
// repeated until it has taken 2 ms, so that the microseconds of cpu.micros() do; what bringing the
// shapes into place takes is subtracted.
void table1(hal::Cpu& cpu);

}  // namespace bench
