// differences.h - what is left out of the comparison with Unicorn 2.0.1 (QEMU 5), and why.
#pragma once

#include <cstdint>
#include <cstring>

#include "sim/cpu/dynarmic/alignment.h"
#include "tb/sim/arm_core/encodings.h"

namespace tb::core {

// ---- The processor: "Not handled" in sim/cpu/arm_core.h ----

// IOC, DZC, OFC, UFC, IXC and IDC, the cumulative flags of exceptions, are not exact.
constexpr std::uint32_t FPSCR_COMPARED = 0xFFFFFF60;

// ---- Unicorn, against ARM DDI 0406C ----

// VCVT from a fixed-point number rounds to the nearest whatever FPSCR says (A8.8.308); Unicorn
// rounds as FPSCR says.
constexpr std::uint32_t FPSCR_ROUNDING = 3u << 22;
constexpr const char* NEAREST_ALONE[] = {"VCVT from fixed"};

// In an IT block MOVS of 16 bits is UNPREDICTABLE (A8.8.104).
//
// An ISB leaves the IT block as it is (A2.5.2); with Unicorn the instructions after it lose their
// conditions.
constexpr const char* NOT_IN_IT[] = {"MOVS", "ISB"};

// It does not test what :<align> of VLD1 to VLD4 asks for, nor anything else of alignment.  QEMU
// does, but only 16 bytes where :256 asks for 32.
inline bool asks_for_more(std::uint32_t arm, std::uint32_t tested) {
    const sim::Alignment asked = sim::alignment(arm, false);
    return (arm & 0xFF100000) == 0xF4000000 && asked.always && asked.bytes > tested;
}

// It does not ask CPACR, does not let the user mode write CPSR.E by MSR, and has other values of
// VFP's identification.  Bits 23:20 of CPSR and SPSR are reserved.  system_items.cpp leaves all
// these out.

template <std::size_t N>
bool is_one_of(const char* const (&names)[N], const Encoding& row) {
    for (const char* const name : names)
        if (std::strcmp(name, row.name) == 0) return true;
    return false;
}

inline bool is_compared(const Encoding& row, bool nearest) {
    return nearest || !is_one_of(NEAREST_ALONE, row);
}
inline bool is_compared_in_it(const Encoding& row) { return !is_one_of(NOT_IN_IT, row); }

}  // namespace tb::core
