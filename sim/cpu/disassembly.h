// disassembly.h - an instruction in words, for messages.
#pragma once

#include <cstdint>
#include <string>

#include "sim/cpu/arm_core.h"

namespace sim {

// "ldr r2, [r0, #4]"; "" if there is none at `address`, or it is none of ARM's.  By Capstone, which
// knows ARMv8's instructions, too.
std::string disassembly(const ArmCore& core, std::uint32_t address);

// Why the Cortex-A9 has no such instruction: "SDIV and UDIV are not in a Cortex-A9; ...".  "" if it
// has, or if that is not known.
std::string absent_from_cortex_a9(const std::string& instruction);

}  // namespace sim
