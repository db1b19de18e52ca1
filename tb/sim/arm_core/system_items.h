// system_items.h - random instructions of an operating system, as items of a stream.
#pragma once

#include "tb/sim/arm_core/maker.h"
#include "tb/sim/arm_core/stream.h"

namespace tb::core {

// Gives each mode registers of its own, and lets VFP and NEON be used.
Item system_begin(Maker& maker, bool thumb);
// `at`: its offset from the stream's begin.  It leaves the processor in the stream's instruction
// set, and in whatever mode.  In the user mode most of them end the stream: they are undefined.
Item system_item(Maker& maker, bool thumb, std::uint32_t at);
// Stores the registers that each mode has of its own.
Item system_end(Maker& maker, bool thumb);

}  // namespace tb::core
