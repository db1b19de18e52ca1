// multiples.cpp - loads and stores of several registers that dynarmic does not have: RFE, SRS, LDM
// and STM of the user mode's registers, LDM with its base in the list.
//
// They change registers after all their accesses, so one that aborts has changed nothing.
#include "sim/cpu/dynarmic/engine.h"
#include "sim/cpu/dynarmic/instructions.h"

namespace sim {

namespace {

// The lowest address of `bytes`, of which `base` is one end.
std::uint32_t first_address(std::uint32_t base, std::uint32_t bytes, bool up, bool before) {
    return up ? base + (before ? 4 : 0) : base - bytes + (before ? 0 : 4);
}

}  // namespace

// RFE: pc and CPSR from two words.
bool ArmCore::Engine::return_from(std::uint32_t base, bool up, bool before,
                                  std::optional<unsigned> write_back) {
    if (!cpu.privileged()) return false;
    const std::uint32_t at = first_address(base, 8, up, before);
    const std::uint32_t to = cpu.in_order(data.load<std::uint32_t>(at)),
                        value = cpu.in_order(data.load<std::uint32_t>(at + 4));
    if (!data.is_done()) return false;
    if (write_back) cpu.r()[*write_back] = up ? base + 8 : base - 8;
    registers.set_cpsr(value);
    cpu.go_to(to);
    return true;
}

// SRS: r14 and SPSR to the stack of mode `to`.
bool ArmCore::Engine::save_return(std::uint32_t to, bool up, bool before, bool write_back) {
    if (!cpu.privileged() || cpu.mode() == arm_mode::SYS) return false;
    const std::uint32_t link = cpu.r()[14], saved = cpu.spsr(), now = cpu.mode();
    cpu.banked.change(cpu.r(), now, to);
    const std::uint32_t base = cpu.r()[13];
    cpu.banked.change(cpu.r(), to, now);
    const std::uint32_t at = first_address(base, 8, up, before);
    data.store(at, cpu.in_order(link));
    data.store(at + 4, cpu.in_order(saved));
    if (!data.is_done()) return false;
    if (write_back) {
        cpu.banked.change(cpu.r(), now, to);
        cpu.r()[13] = up ? base + 8 : base - 8;
        cpu.banked.change(cpu.r(), to, now);
    }
    return true;
}

bool ArmCore::Engine::load_with_base(unsigned base, unsigned list, bool up, bool before) {
    std::uint32_t at = first_address(cpu.r()[base], 4 * bits_of(list), up, before);
    std::array<std::uint32_t, 16> values{};
    for (unsigned i = 0; i < 16; ++i) {
        if (!(list >> i & 1)) continue;
        values[i] = cpu.in_order(data.load<std::uint32_t>(at));
        at += 4;
    }
    if (!data.is_done()) return false;
    for (unsigned i = 0; i < 15; ++i)
        if (list >> i & 1) cpu.r()[i] = values[i];
    if (!(list >> 15 & 1)) return true;
    cpu.jit->SetCpsr((cpu.cpsr() & ~arm_cpsr::T) | (values[15] & 1 ? arm_cpsr::T : 0));
    cpu.go_to(values[15]);
    return true;
}

// LDM and STM with ^: the user mode's registers, or with pc in the list an exception's return.
bool ArmCore::Engine::load_store_multiple(std::uint32_t w) {
    if (!cpu.privileged()) return false;
    const bool load_it = w >> 20 & 1, up = w >> 23 & 1, before = w >> 24 & 1, write = w >> 21 & 1;
    const unsigned base = w >> 16 & 0xF;
    const bool returns = load_it && (w >> 15 & 1);
    const std::uint32_t bytes = 4 * bits_of(w & 0xFFFF);
    std::uint32_t at = first_address(cpu.r()[base], bytes, up, before);
    std::array<std::uint32_t, 16> values{};
    for (unsigned i = 0; i < 16; ++i) {
        if (!(w >> i & 1)) continue;
        if (load_it)
            values[i] = cpu.in_order(data.load<std::uint32_t>(at));
        else
            data.store(at, cpu.in_order(i == 15 ? cpu.r()[15] + 4
                                                : cpu.banked.user(cpu.r(), cpu.mode(), i)));
        at += 4;
    }
    if (!data.is_done()) return false;
    if (write) cpu.r()[base] = up ? cpu.r()[base] + bytes : cpu.r()[base] - bytes;
    if (!load_it) return true;
    for (unsigned i = 0; i < 15; ++i) {
        if (!(w >> i & 1)) continue;
        (returns ? cpu.r()[i] : cpu.banked.user(cpu.r(), cpu.mode(), i)) = values[i];
    }
    if (!returns) return true;
    registers.set_cpsr(cpu.spsr());
    cpu.go_to(values[15]);
    return true;
}

}  // namespace sim
