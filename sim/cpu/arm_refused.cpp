// arm_refused.cpp - ArmCpu's words for an instruction that the processor does not execute, and for
// an unaligned access: what it is, why, and what to do
#include "sim/cpu/arm_cpu.h"

#include <fmt/format.h>

#include "sim/cpu/disassembly.h"

namespace sim {

namespace {

constexpr std::uint32_t SCTLR_M = 1, SCTLR_A = 2;

// Of VFP or NEON (ARM DDI 0406C, A5.7, A6.3.18).
bool is_floating_point(std::uint32_t word, bool thumb) {
    if ((word & 0x0C000E00) == 0x0C000A00 && (!thumb || (word & 0xE0000000) == 0xE0000000))
        return true;
    if (thumb) return (word & 0xEF000000) == 0xEF000000 || (word & 0xFF100000) == 0xF9000000;
    return (word & 0xFE000000) == 0xF2000000 || (word & 0xFF100000) == 0xF4000000;
}

std::uint32_t word_at(const ArmCore& core, std::uint32_t pc) {
    std::uint32_t word = 0;
    core.read_ram(pc, &word, sizeof word);
    return core.cpsr() & arm_cpsr::T ? word << 16 | word >> 16 : word;
}

}  // namespace

std::string ArmCpu::undefined() const {
    const std::uint32_t word = word_at(core_, core_.pc());
    const std::string instruction = disassembly(core_, core_.pc());
    std::string why = absent_from_cortex_a9(instruction);
    if (why.empty() && !core_.floating_point() &&
        is_floating_point(word, core_.cpsr() & arm_cpsr::T))
        why =
            "the floating-point unit is off, as after reset: switch it on by CPACR and FPEXC, as "
            "sw/examples/start.S does; on a board another program may have done so before";
    return fmt::format("undefined instruction: {}{}",
                       instruction.empty() ? fmt::format("0x{:08X}", word) : instruction,
                       why.empty() ? "" : " (" + why + ")");
}

std::string ArmCpu::unaligned() const {
    const ArmFault& f = core_.fault();
    const std::uint32_t control = core_.cp15(cp15::SCTLR);
    const bool mmu_off = !(control & SCTLR_M) && !kernel_;
    const char* const when = f.always            ? "in any memory; align the data by .align"
                             : control & SCTLR_A ? "with SCTLR.A"
                             : mmu_off           ? "with the MMU off"
                                                 : "in Device or Strongly-ordered memory";
    return fmt::format(
        "data abort: {} at 0x{:08X}, expected a multiple of {} ({}{})",
        disassembly(core_, core_.pc()), f.address, f.multiple_of, when,
        f.always ? "" : "; build with -mno-unaligned-access, align the data by .align");
}

}  // namespace sim
