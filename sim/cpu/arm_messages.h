// arm_messages.h - messages about the program at an exception: the callers of its last
// function; an instruction that the processor does not execute; an unaligned access
#pragma once

#include <string>

#include "sim/cpu/arm_core.h"
#include "sim/cpu/elf.h"

namespace sim {

// "; called from draw, main": LR, and the last five words on the stack that are return addresses of
// a BL or BLX.  So it may name a function that has returned long ago.  Or "".
std::string callers(const ArmCore& core, const ElfProgram& elf);

// "undefined instruction: ... (why, and what to do)", of the one at pc.
std::string undefined_instruction(const ArmCore& core);

// "data abort: ... at 0x..., expected a multiple of 4 (...)", of core.fault().  `on_linux`: a
// kernel has switched the MMU on, though the core does not know of it.
std::string unaligned_access(const ArmCore& core, bool on_linux);

}  // namespace sim
