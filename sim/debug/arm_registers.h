// arm_registers.h - the ARM's registers, as GDB is told of them.
#pragma once

#include "sim/debug/gdb_registers.h"

namespace sim {

// By number: 0 - 15 r0 - r15, 16 cpsr, 17 - 48 d0 - d31, 49 fpscr.
namespace arm_register {
constexpr unsigned PC = 15, CPSR = 16, D0 = 17, FPSCR = 49, COUNT = 50;
}

const GdbRegisters& arm_registers();

}  // namespace sim
