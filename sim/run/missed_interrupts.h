// missed_interrupts.h - why interrupts that a program may wait for were not taken.
//
//   pending, and kept back      by the interrupt controller or by the CPSR: which registers
//   enabled in the controller   and the device, which has something to say, does not raise it: its
//                               mask
//   taken, and up again         the handler does not take the cause away
//
// An interrupt counts as kept back after a millisecond.  Programs that use no interrupts, and poll
// what would raise them, are left alone: nothing is enabled, neither in the controller nor in the
// CPSR.
//
// Not handled: IRDA, whose bytes can be counted by reading alone; FIQ's own vector.
#pragma once

#include <string>
#include <vector>

#include "sim/chip/computer.h"
#include "sim/chip/nios_v_computer.h"

namespace sim {

// A line each.  Once the run is over, outside simulated time: reading moves the board.  `computer`
// is `system` where the chip has this project's own fabric, or null: of somebody else's design the
// devices are not known.
std::vector<std::string> missed_interrupts(ProcessorSystem& system, Computer* computer);
std::vector<std::string> missed_interrupts(NiosVComputer& computer);

}  // namespace sim
