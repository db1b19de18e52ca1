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
    if (!privileged()) return false;
    const std::uint32_t at = first_address(base, 8, up, before);
    const std::uint32_t to = in_order(load<std::uint32_t>(at)),
                        value = in_order(load<std::uint32_t>(at + 4));
    if (aborted || watched) return false;
    if (write_back) r()[*write_back] = up ? base + 8 : base - 8;
    set_cpsr(value);
    core.set_reg(15, to);
    return true;
}

// SRS: r14 and SPSR to the stack of mode `to`.
bool ArmCore::Engine::save_return(std::uint32_t to, bool up, bool before, bool write_back) {
    if (!privileged() || mode() == arm_mode::SYS) return false;
    const std::uint32_t link = r()[14], saved = spsr(), now = mode();
    banked.change(r(), now, to);
    const std::uint32_t base = r()[13];
    banked.change(r(), to, now);
    const std::uint32_t at = first_address(base, 8, up, before);
    store(at, in_order(link));
    store(at + 4, in_order(saved));
    if (aborted || watched) return false;
    if (write_back) {
        banked.change(r(), now, to);
        r()[13] = up ? base + 8 : base - 8;
        banked.change(r(), to, now);
    }
    return true;
}

bool ArmCore::Engine::load_with_base(unsigned base, unsigned list, bool up, bool before) {
    std::uint32_t at = first_address(r()[base], 4 * bits_of(list), up, before);
    std::array<std::uint32_t, 16> values{};
    for (unsigned i = 0; i < 16; ++i) {
        if (!(list >> i & 1)) continue;
        values[i] = in_order(load<std::uint32_t>(at));
        at += 4;
    }
    if (aborted || watched) return false;
    for (unsigned i = 0; i < 15; ++i)
        if (list >> i & 1) r()[i] = values[i];
    if (!(list >> 15 & 1)) return true;
    jit->SetCpsr((jit->Cpsr() & ~arm_cpsr::T) | (values[15] & 1 ? arm_cpsr::T : 0));
    core.set_reg(15, values[15]);
    return true;
}

// LDM and STM with ^: the user mode's registers, or with pc in the list an exception's return.
bool ArmCore::Engine::load_store_multiple(std::uint32_t w) {
    if (!privileged()) return false;
    const bool load_it = w >> 20 & 1, up = w >> 23 & 1, before = w >> 24 & 1, write = w >> 21 & 1;
    const unsigned base = w >> 16 & 0xF;
    const bool returns = load_it && (w >> 15 & 1);
    const std::uint32_t bytes = 4 * bits_of(w & 0xFFFF);
    std::uint32_t at = first_address(r()[base], bytes, up, before);
    std::array<std::uint32_t, 16> values{};
    for (unsigned i = 0; i < 16; ++i) {
        if (!(w >> i & 1)) continue;
        if (load_it)
            values[i] = in_order(load<std::uint32_t>(at));
        else
            store(at, in_order(i == 15 ? r()[15] + 4 : banked.user(r(), mode(), i)));
        at += 4;
    }
    if (aborted || watched) return false;
    if (write) r()[base] = up ? r()[base] + bytes : r()[base] - bytes;
    if (!load_it) return true;
    for (unsigned i = 0; i < 15; ++i) {
        if (!(w >> i & 1)) continue;
        (returns ? r()[i] : banked.user(r(), mode(), i)) = values[i];
    }
    if (!returns) return true;
    set_cpsr(spsr());
    core.set_reg(15, values[15]);
    return true;
}

}  // namespace sim
