// translation_tables.h - a walk of ARMv7-A's short-descriptor translation tables.
//
// Sections of 1 MB, supersections of 16 MB (below 4 GB), large pages of 64 KB, small pages of 4 KB;
// domains, access permissions in both models, execute-never, memory types with and without TEX
// remap.  Source: ARM DDI 0406C, B3.5 - B3.8.
//
// Not handled: the access flag's update by hardware, the long-descriptor format (the Cortex-A9 has
// none).  With the MMU off nothing is Normal: data are Strongly-ordered then.
#pragma once

#include <cstdint>

#include "sim/cpu/dynarmic/cp15.h"
#include "sim/cpu/dynarmic/memory_map.h"

namespace sim {

struct Translation {
    std::uint32_t physical = 0;  // of the address asked for
    unsigned access = 0;         // arm_access that the tables allow
    // Of a refused access, as DFSR and IFSR have it (bits 3:0 and 10; DFSR's domain in 7:4).
    std::uint32_t status = 0;
    bool normal = false;  // Normal memory; else Device or Strongly-ordered
    // PAR's bits 11:0 of a translation that succeeds: attributes of the memory, supersection.
    std::uint32_t attributes = 0;
};

// `privileged`: the access is not of the user mode.  With SCTLR.M clear the physical address is the
// virtual one.
Translation translate(const Cp15Registers& cp15, const MemoryMap& memory, std::uint32_t address,
                      bool privileged);

// AxCACHE of an access there, as the Cortex-A9 has it: for Normal memory by the outer attributes.
unsigned axi_cache(const Translation& translation);

// What PAR has after an address translation operation: the physical address, or the fault's status.
// `needed`: arm_access.
std::uint32_t par(const Translation& translation, unsigned needed);

}  // namespace sim
