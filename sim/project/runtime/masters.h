// masters.h - the processor's memory and peripherals, as masters in the design reach them through
// DPI (rtl/ip/de1sim_hps_memory.vh)
#pragma once

#include "sim/project/model.h"

namespace sim::project {

// That of the design that is opened next; null: there is no program, nobody has set the memory up,
// and nothing is answered.  Holds for all models of the process: a DPI function has no other
// context.
void set_processor_memory(ProcessorMemory* memory);

}  // namespace sim::project
