// single.cpp - single loads and stores that translated code does not do: those that the bus serves,
// LDRT, STRT and their kind, which have the user mode's rights, and SWP
#include "sim/cpu/dynarmic/engine.h"
#include "sim/cpu/dynarmic/instructions.h"

namespace sim {

namespace {

constexpr std::uint32_t SCTLR_SW = 1u << 10;  // SWP and SWPB are instructions

}  // namespace

bool is_unprivileged(std::uint32_t w, bool thumb) {
    if (thumb) {
        if (!is(w, 0xFE800F00, 0xF8000E00) || (w >> 16 & 0xF) == 15) return false;
        const unsigned size = w >> 21 & 3;
        return is(w, 0x01000000, 0) ? size != 3 : size < 2 && (w >> 20 & 1);  // signed: loads alone
    }
    if (w >> 28 == 15) return false;
    if (is(w, 0x0D200000, 0x04200000)) return !is(w, 0x02000010, 0x02000010);
    const unsigned kind = w >> 5 & 3;
    return is(w, 0x0F200090, 0x00200090) && (kind == 1 || (kind != 0 && (w >> 20 & 1)));
}

bool is_swap(std::uint32_t w) { return is(w, 0x0FB00FF0, 0x01000090) && w >> 28 != 15; }

// As the LDR or STR that it is but for its rights.
bool ArmCore::Engine::unprivileged(std::uint32_t w, bool in_thumb) {
    const std::uint32_t plain = in_thumb ? (w | 1u << 23) & ~0xF00u : w & ~(1u << 21);
    const std::uint32_t pc = cpu.r()[15] - 4;
    const auto access = single_access(plain, in_thumb, pc, cpu.r().data(), cpu.carry());
    if (!access) return false;
    const Translation to = mmu.walk(access->address, false);
    if (!(to.access & (access->load ? arm_access::READ : arm_access::WRITE))) {
        data.refuse({access->address, !access->load, true, to.status});
        return false;
    }
    return data.transfer(*access);
}

bool ArmCore::Engine::swap(std::uint32_t w) {
    if (!(cpu.cp15.value(cp15::SCTLR) & SCTLR_SW)) return false;
    const std::uint32_t address = cpu.r()[w >> 16 & 0xF], value = cpu.r()[w & 0xF];
    std::uint32_t old;
    if (w >> 22 & 1) {
        old = data.load<std::uint8_t>(address);
        data.store(address, static_cast<std::uint8_t>(value));
    } else {
        old = cpu.in_order(data.load<std::uint32_t>(address));
        data.store(address, cpu.in_order(value));
    }
    if (!data.is_done()) return false;
    cpu.r()[w >> 12 & 0xF] = old;
    return true;
}

}  // namespace sim
