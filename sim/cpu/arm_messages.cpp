#include "sim/cpu/arm_messages.h"

#include <array>

#include <fmt/format.h>

#include "sim/cpu/disassembly.h"

namespace sim {

namespace {

constexpr unsigned WORDS = 256, MOST = 5;  // words of the stack that are examined; names

// The instruction before `address` is a BL or BLX, by the encodings of ARM DDI 0406C, A8.8.25 - 26.
bool is_behind_a_call(const ArmCore& core, std::uint32_t address) {
    if (address & 1) {
        std::array<std::uint16_t, 2> halves{};
        if (!core.read_ram(address - 5, halves.data(), 4)) return false;
        const bool wide = (halves[0] & 0xF800) == 0xF000 && (halves[1] & 0xC000) == 0xC000;
        return wide || (halves[1] & 0xFF87) == 0x4780;
    }
    std::uint32_t word = 0;
    if (address % 4 != 0 || !core.read_ram(address - 4, &word, 4)) return false;
    const bool always = word >> 28 == 0xF;
    return (always && (word & 0x0E000000) == 0x0A000000) ||
           (!always && ((word & 0x0F000000) == 0x0B000000 || (word & 0x0FFFFFF0) == 0x012FFF30));
}

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

std::string callers(const ArmCore& core, const ElfProgram& elf) {
    std::string text;
    std::uint32_t last = 0;
    unsigned names = 0;
    const auto add = [&](std::uint32_t address) {
        if (names == MOST || address == last || !is_behind_a_call(core, address)) return;
        const std::string name = elf.function((address & ~1u) - 1);
        if (name.empty()) return;
        last = address;
        text += (names++ == 0 ? "; called from " : ", ") + name.substr(0, name.find("+0x"));
    };
    add(core.reg(14));
    for (unsigned i = 0; i < WORDS && names < MOST; ++i) {
        std::uint32_t word = 0;
        if (!core.read_ram(core.reg(13) + 4 * i, &word, 4)) break;
        add(word);
    }
    return text;
}

std::string undefined_instruction(const ArmCore& core) {
    const std::uint32_t word = word_at(core, core.pc());
    const std::string instruction = disassembly(core, core.pc());
    std::string why = absent_from_cortex_a9(instruction);
    if (why.empty() && !core.floating_point() && is_floating_point(word, core.cpsr() & arm_cpsr::T))
        why =
            "the floating-point unit is off, as after reset: switch it on by CPACR and FPEXC, as "
            "sw/examples/start.S does; on a board another program may have done so before";
    return fmt::format("undefined instruction: {}{}",
                       instruction.empty() ? fmt::format("0x{:08X}", word) : instruction,
                       why.empty() ? "" : " (" + why + ")");
}

std::string unaligned_access(const ArmCore& core, bool on_linux) {
    const ArmFault& f = core.fault();
    const std::uint32_t control = core.cp15(cp15::SCTLR);
    const bool mmu_off = !(control & SCTLR_M) && !on_linux;
    const char* const when = f.always            ? "in any memory; align the data by .align"
                             : control & SCTLR_A ? "with SCTLR.A"
                             : mmu_off           ? "with the MMU off"
                                                 : "in Device or Strongly-ordered memory";
    return fmt::format(
        "data abort: {} at 0x{:08X}, expected a multiple of {} ({}{})",
        disassembly(core, core.pc()), f.address, f.multiple_of, when,
        f.always ? "" : "; build with -mno-unaligned-access, align the data by .align");
}

}  // namespace sim
