// arm_exceptions.h - how an ARMv7-A processor enters an exception: mode, banked registers, vector.
//
//   exception        mode  vector  r14                              also sets
//   undefined        UND   +0x04   after the instruction            I
//   SVC              SVC   +0x08   after the instruction            I
//   prefetch abort   ABT   +0x0C   the instruction + 4              I A, IFSR, IFAR
//   data abort       ABT   +0x10   the instruction + 8              I A, DFSR, DFAR
//   the same, asynchronous         the next instruction + 8         I A, DFSR
//   IRQ              IRQ   +0x18   the next instruction + 4         I A
//   FIQ              FIQ   +0x1C   the next instruction + 4         I A F
//
// The table is at VBAR, or at 0xFFFF0000 with SCTLR.V.  Source: ARM DDI 0406C, B1.8 and B1.9.
//
// Not handled: Monitor and Hyp mode (no security extensions).
#pragma once

#include <cstdint>

#include "sim/cpu/arm_core.h"

namespace sim {

enum class ArmException {
    UNDEFINED,
    SVC,
    PREFETCH_ABORT,
    DATA_ABORT,
    ASYNCHRONOUS_ABORT,
    IRQ,
    FIQ
};

inline bool is_asynchronous(ArmException exception) {
    return exception >= ArmException::ASYNCHRONOUS_ABORT;
}

// Fault status: an abort from the bus (external, not on a table walk; synchronous or not, by SLVERR
// or by DECERR), one from the translation tables, an unaligned access, a BKPT instruction.
namespace fault_status {
constexpr std::uint32_t ALIGNMENT = 0x1, EXTERNAL = 0x8, TRANSLATION = 0x5, DEBUG = 0x2,
                        ASYNCHRONOUS = 0x406, WRITE = 1u << 11, SLAVE_ERROR = 1u << 12;
}

std::uint32_t vector_of(const ArmCore& core, ArmException exception);

// Whether the instruction before pc, an SVC, is a request to a debugger: SVC 0x123456, in Thumb
// code SVC 0xAB.  Source: Arm, Semihosting for AArch32 and AArch64.
bool is_semihosting(const ArmCore& core);

// The core must be as run() left it (ArmStop).  `status` and `address` are those of an abort.
void enter(ArmCore& core, ArmException exception, std::uint32_t status = 0,
           std::uint32_t address = 0);

}  // namespace sim
