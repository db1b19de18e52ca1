// system_transfers.cpp - loads and stores that dynarmic does not have: RFE, SRS, LDM and STM of the
// user mode's registers, LDM with its base in the list, LDRT and STRT and their kind, SWP.
//
// They change registers after all their accesses, so one that aborts has changed nothing.
#include "sim/cpu/dynarmic/instructions.h"
#include "sim/cpu/dynarmic/system_instructions.h"

namespace sim {

namespace {

constexpr std::uint32_t SCTLR_SW = 1u << 10;  // SWP and SWPB are instructions

// The lowest address of `bytes`, of which `base` is one end.
std::uint32_t first_address(std::uint32_t base, std::uint32_t bytes, bool up, bool before) {
    return up ? base + (before ? 4 : 0) : base - bytes + (before ? 0 : 4);
}

}  // namespace

// ---- Several registers --------------------------------------------------------------------------

// RFE: pc and CPSR from two words.
bool SystemInstructions::return_from(std::uint32_t base, bool up, bool before,
                                     std::optional<unsigned> write_back) {
    if (!cpu_.privileged()) return false;
    const std::uint32_t at = first_address(base, 8, up, before);
    const std::uint32_t to = cpu_.in_order(data_.load<std::uint32_t>(at)),
                        value = cpu_.in_order(data_.load<std::uint32_t>(at + 4));
    if (!data_.is_done()) return false;
    if (write_back) cpu_.r()[*write_back] = up ? base + 8 : base - 8;
    registers_.set_cpsr(value);
    cpu_.go_to(to);
    return true;
}

// SRS: r14 and SPSR to the stack of mode `to`.
bool SystemInstructions::save_return(std::uint32_t to, bool up, bool before, bool write_back) {
    if (!cpu_.privileged() || cpu_.mode() == arm_mode::SYS) return false;
    const std::uint32_t link = cpu_.r()[14], saved = cpu_.spsr(), now = cpu_.mode();
    cpu_.banked.change(cpu_.r(), now, to);
    const std::uint32_t base = cpu_.r()[13];
    cpu_.banked.change(cpu_.r(), to, now);
    const std::uint32_t at = first_address(base, 8, up, before);
    data_.store(at, cpu_.in_order(link));
    data_.store(at + 4, cpu_.in_order(saved));
    if (!data_.is_done()) return false;
    if (write_back) {
        cpu_.banked.change(cpu_.r(), now, to);
        cpu_.r()[13] = up ? base + 8 : base - 8;
        cpu_.banked.change(cpu_.r(), to, now);
    }
    return true;
}

bool SystemInstructions::load_with_base(unsigned base, unsigned list, bool up, bool before) {
    std::uint32_t at = first_address(cpu_.r()[base], 4 * bits_of(list), up, before);
    std::array<std::uint32_t, 16> values{};
    for (unsigned i = 0; i < 16; ++i) {
        if (!(list >> i & 1)) continue;
        values[i] = cpu_.in_order(data_.load<std::uint32_t>(at));
        at += 4;
    }
    if (!data_.is_done()) return false;
    for (unsigned i = 0; i < 15; ++i)
        if (list >> i & 1) cpu_.r()[i] = values[i];
    if (!(list >> 15 & 1)) return true;
    cpu_.jit->SetCpsr((cpu_.cpsr() & ~arm_cpsr::T) | (values[15] & 1 ? arm_cpsr::T : 0));
    cpu_.go_to(values[15]);
    return true;
}

// LDM and STM with ^: the user mode's registers, or with pc in the list an exception's return.
bool SystemInstructions::load_store_multiple(std::uint32_t w) {
    if (!cpu_.privileged()) return false;
    const bool load_it = w >> 20 & 1, up = w >> 23 & 1, before = w >> 24 & 1, write = w >> 21 & 1;
    const unsigned base = w >> 16 & 0xF;
    const bool returns = load_it && (w >> 15 & 1);
    const std::uint32_t bytes = 4 * bits_of(w & 0xFFFF);
    std::uint32_t at = first_address(cpu_.r()[base], bytes, up, before);
    std::array<std::uint32_t, 16> values{};
    for (unsigned i = 0; i < 16; ++i) {
        if (!(w >> i & 1)) continue;
        if (load_it)
            values[i] = cpu_.in_order(data_.load<std::uint32_t>(at));
        else
            data_.store(at, cpu_.in_order(i == 15 ? cpu_.r()[15] + 4
                                                  : cpu_.banked.user(cpu_.r(), cpu_.mode(), i)));
        at += 4;
    }
    if (!data_.is_done()) return false;
    if (write) cpu_.r()[base] = up ? cpu_.r()[base] + bytes : cpu_.r()[base] - bytes;
    if (!load_it) return true;
    for (unsigned i = 0; i < 15; ++i) {
        if (!(w >> i & 1)) continue;
        (returns ? cpu_.r()[i] : cpu_.banked.user(cpu_.r(), cpu_.mode(), i)) = values[i];
    }
    if (!returns) return true;
    registers_.set_cpsr(cpu_.spsr());
    cpu_.go_to(values[15]);
    return true;
}

// ---- Single accesses ----------------------------------------------------------------------------

// LDRT, STRT and their kind: as the LDR or STR that it is, but with the user mode's rights.
bool SystemInstructions::unprivileged(std::uint32_t w, bool in_thumb) {
    const std::uint32_t plain = in_thumb ? (w | 1u << 23) & ~0xF00u : w & ~(1u << 21);
    const std::uint32_t pc = cpu_.r()[15] - 4;
    const auto access = single_access(plain, in_thumb, pc, cpu_.r().data(), cpu_.carry());
    if (!access) return false;
    const Translation to = mmu_.walk(access->address, false);
    if (!(to.access & (access->load ? arm_access::READ : arm_access::WRITE))) {
        data_.refuse({access->address, !access->load, true, to.status});
        return false;
    }
    return data_.transfer(*access);
}

bool SystemInstructions::swap(std::uint32_t w) {
    if (!(cpu_.cp15.value(cp15::SCTLR) & SCTLR_SW)) return false;
    const std::uint32_t address = cpu_.r()[w >> 16 & 0xF], value = cpu_.r()[w & 0xF];
    std::uint32_t old;
    if (w >> 22 & 1) {
        old = data_.load<std::uint8_t>(address);
        data_.store(address, static_cast<std::uint8_t>(value));
    } else {
        old = cpu_.in_order(data_.load<std::uint32_t>(address));
        data_.store(address, cpu_.in_order(value));
    }
    if (!data_.is_done()) return false;
    cpu_.r()[w >> 12 & 0xF] = old;
    return true;
}

}  // namespace sim
