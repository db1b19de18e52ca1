// table1.h - the paper's table on the processor that this runs on: no operating system, no files.
#pragma once

#include "hal/cpu.h"

namespace bench {

// Prints a line per cell, "square,100,simd,12345": shape, shapes inserted, algorithm, nanoseconds
// per tick for the pairs alone; then "table1 done".  16-pixel shapes as in workload.h.  A cell is
// repeated until it has taken 2 ms, so that the resolution of cpu.micros() suffices.  The time to
// copy the shapes is subtracted.
void table1(hal::Cpu& cpu);

}  // namespace bench
