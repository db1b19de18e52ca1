// cpu_state.h - the processor's registers, and what they let the present mode do.
//
// Most are dynarmic's.  It has no modes but the user mode, so the banked registers, FPEXC and
// coprocessor 15 stand beside.
//
// A change here is of the register alone: system_registers.h has what else it means.
#pragma once

#include <dynarmic/interface/A32/a32.h>

#include <array>
#include <cstdint>
#include <memory>

#include "sim/cpu/arm_core.h"
#include "sim/cpu/dynarmic/cp15.h"
#include "sim/cpu/dynarmic/modes.h"

namespace sim {

struct CpuState {
    std::unique_ptr<Dynarmic::A32::Jit> jit;  // r0 - r15, CPSR, VFP's registers, FPSCR
    BankedRegisters banked;
    Cp15Registers cp15;
    std::uint32_t fpexc = 0;

    std::array<std::uint32_t, 16>& r() { return jit->Regs(); }
    // The program goes on at `to`, in the present instruction set.
    void go_to(std::uint32_t to) { r()[15] = to & ~(thumb() ? 1u : 3u); }
    std::uint32_t& spsr() { return banked.spsr(mode()); }

    std::uint32_t cpsr() const { return jit->Cpsr(); }
    bool thumb() const { return cpsr() & arm_cpsr::T; }
    bool carry() const { return cpsr() >> 29 & 1; }
    std::uint32_t mode() const { return cpsr() & arm_cpsr::MODE; }
    bool privileged() const { return mode() != arm_mode::USR; }

    // CPACR's cp10: 1 is for privileged modes, 3 for all.
    unsigned floating_point_rights() const { return cp15.value(cp15::CPACR) >> 20 & 3; }
    bool may_use_floating_point() const {
        return floating_point_rights() == 3 || (floating_point_rights() == 1 && privileged());
    }
    bool floating_point() const { return (fpexc >> 30 & 1) && may_use_floating_point(); }

    // Swaps a value's bytes if CPSR.E asks for big-endian data; translated code does so by itself.
    template <class T>
    T in_order(T value) const {
        if (!(cpsr() & arm_cpsr::E)) return value;
        if constexpr (sizeof(T) == 4) return __builtin_bswap32(value);
        if constexpr (sizeof(T) == 2) return __builtin_bswap16(value);
        return value;
    }
};

}  // namespace sim
