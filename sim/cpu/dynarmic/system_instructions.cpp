// They change registers after all their accesses, so one that aborts has changed nothing.
#include "sim/cpu/dynarmic/system_instructions.h"

#include "sim/cpu/dynarmic/instructions.h"
#include "sim/cpu/dynarmic/missed_neon.h"

namespace sim {

namespace {

std::uint32_t turned(std::uint32_t value, unsigned by) {
    return by ? value >> by | value << (32 - by) : value;
}

constexpr std::uint32_t SEEN_BY_MRS = 0xF8FF03DF;  // neither T nor IT nor J
constexpr std::uint32_t FPSCR_QC = 1u << 27;
constexpr std::uint32_t FPSID = 0x41033094, MVFR0 = 0x10110222, MVFR1 = 0x01111111;

}  // namespace

bool SystemInstructions::execute(std::uint32_t pc, std::uint32_t word, bool in_thumb) {
    if (is_absent(word, in_thumb)) return false;
    data_.begin_step(alignment(word, in_thumb));
    cpu_.r()[15] = pc + (in_thumb && word <= 0xFFFF ? 2 : 4);
    bool done = true;
    if (in_thumb) {
        const std::uint32_t cpsr = cpu_.cpsr();
        cpu_.jit->SetCpsr(with_it_state(cpsr, next_it(it_state(cpsr))));
        done = thumb(word);
        if (!done) cpu_.jit->SetCpsr(cpsr);
    } else if (word >> 28 == 15 || condition_holds(word >> 28, cpu_.cpsr())) {
        done = arm(word);
    }
    if (!done) cpu_.r()[15] = pc;
    cpu_.jit->ClearHalt(Dynarmic::HaltReason::MemoryAbort);  // of its accesses: nothing runs now
    data_.end_step();
    return done;
}

bool SystemInstructions::arm(std::uint32_t w) {
    const bool up = w >> 23 & 1, before = w >> 24 & 1, write = w >> 21 & 1;
    if (is(w, 0xFFF1FE20, 0xF1000000)) {
        change_state(w >> 18 & 3, w >> 17 & 1, w & 0x1C0, w & 0x1F);
        return true;
    }
    if (is(w, 0xFE50FFFF, 0xF8100A00)) {
        const unsigned base = w >> 16 & 0xF;
        return return_from(cpu_.r()[base], up, before, write ? std::optional{base} : std::nullopt);
    }
    if (is(w, 0xFE5FFFE0, 0xF84D0500)) return save_return(w & 0x1F, up, before, write);
    if (w >> 28 != 15) {
        if (is(w, 0x0FB00000, 0x01000000) || is(w, 0x0FB00000, 0x01200000) ||
            is(w, 0x0FB0F000, 0x0320F000)) {
            if (status(w)) return true;
        }
        if (is_unprivileged(w, false)) return unprivileged(w, false);
        if (is_swap(w)) return swap(w);
        if (loads_its_base(w, false)) return load_with_base(w >> 16 & 0xF, w & 0xFFFF, up, before);
        if (is(w, 0x0E400000, 0x08400000)) return load_store_multiple(w);
        if (is(w, 0x0C10F000, 0x0010F000)) return exception_return(w);
    }
    if (w >> 28 == 15)
        return is(w, 0xFD30F000, 0xF410F000) ||  // PLI
               neon(w, false);
    return is(w, 0x0C000000, 0x0C000000) && coprocessor(w);
}

bool SystemInstructions::thumb(std::uint32_t w) {
    if (loads_its_base(w, true)) {
        if (w <= 0xFFFF) return load_with_base(w >> 8 & 7, w & 0xFF, true, false);
        const bool up = w >> 23 & 1;
        return load_with_base(w >> 16 & 0xF, w & 0xFFFF, up, !up);
    }
    if (w > 0xFFFF && is_unprivileged(w, true)) return unprivileged(w, true);
    if (is_newton_step(w, true) || is_missed_neon(w, true)) return neon(w, true);
    if (is(w, 0xFFFFFFE8, 0xB660)) {
        change_state(w >> 4 & 1 ? 3 : 2, false, (w & 7) << 6, 0);
        return true;
    }
    if (is(w, 0xFFE0F0FF, 0xF3808000)) {
        write_status(w >> 20 & 1, w >> 8 & 0xF, cpu_.r()[w >> 16 & 0xF]);
        return true;
    }
    if (is(w, 0xFFEFF0FF, 0xF3EF8000)) {
        const bool saved = w >> 20 & 1;
        if (saved && !cpu_.privileged()) return false;
        cpu_.r()[w >> 8 & 0xF] = saved ? cpu_.spsr() : cpu_.cpsr() & SEEN_BY_MRS;
        return true;
    }
    if (is(w, 0xFFFFF800, 0xF3AF8000)) {
        change_state(w >> 9 & 3, w >> 8 & 1, (w & 0xE0) << 1, w & 0x1F);
        return true;
    }
    if (is(w, 0xFFFFFF00, 0xF3DE8F00)) {
        if (!cpu_.privileged() || cpu_.mode() == arm_mode::SYS) return false;
        const std::uint32_t to = cpu_.r()[14] - (w & 0xFF);
        registers_.set_cpsr(cpu_.spsr());
        cpu_.go_to(to);
        return true;
    }
    const bool up = is(w, 0xFF800000, 0xE9800000), write = w >> 21 & 1;
    if (is(w, 0xFFD0FFFF, 0xE810C000) || is(w, 0xFFD0FFFF, 0xE990C000)) {
        const unsigned base = w >> 16 & 0xF;
        return return_from(cpu_.r()[base], up, !up, write ? std::optional{base} : std::nullopt);
    }
    if (is(w, 0xFFDFFFE0, 0xE80DC000) || is(w, 0xFFDFFFE0, 0xE98DC000))
        return save_return(w & 0x1F, up, !up, write);
    return is(w, 0xEC000000, 0xEC000000) && coprocessor(w);
}

// ---- Status registers ---------------------------------------------------------------------------

// MRS and MSR; false for other instructions in the same encoding space.
bool SystemInstructions::status(std::uint32_t w) {
    const bool saved = w >> 22 & 1;
    if (is(w, 0x0FBF0FFF, 0x010F0000)) {
        if (saved && !cpu_.privileged()) return false;
        cpu_.r()[w >> 12 & 0xF] = saved ? cpu_.spsr() : cpu_.cpsr() & SEEN_BY_MRS;
        return true;
    }
    const bool immediate = is(w, 0x0FB0F000, 0x0320F000);
    if (!immediate && !is(w, 0x0FB0FFF0, 0x0120F000)) return false;
    write_status(saved, w >> 16 & 0xF,
                 immediate ? turned(w & 0xFF, w >> 7 & 0x1E) : cpu_.r()[w & 0xF]);
    return true;
}

// `mask`: which bytes of the register, the lowest first.
void SystemInstructions::write_status(bool saved, unsigned mask, std::uint32_t value) {
    std::uint32_t bits = 0;
    for (unsigned byte = 0; byte < 4; ++byte)
        if (mask >> byte & 1) bits |= 0xFFu << (8 * byte);
    if (saved) {
        if (cpu_.privileged() && cpu_.mode() != arm_mode::SYS)
            cpu_.spsr() = (cpu_.spsr() & ~bits) | (value & bits);
        return;
    }
    bits &= cpu_.privileged() ? 0xF80F03DFu : 0xF80F0200u;  // neither T nor IT nor J
    registers_.set_cpsr((cpu_.cpsr() & ~bits) | (value & bits));
}

// CPS: `imod` 2 enables, 3 disables what `masks` (A, I, F as in the CPSR) names.
void SystemInstructions::change_state(unsigned imod, bool change_mode, std::uint32_t masks,
                                      std::uint32_t to) {
    if (!cpu_.privileged()) return;
    std::uint32_t value = cpu_.cpsr();
    if (imod == 2) value &= ~masks;
    if (imod == 3) value |= masks;
    if (change_mode) value = (value & ~arm_cpsr::MODE) | to;
    registers_.set_cpsr(value);
}

// ---- Returns from exceptions --------------------------------------------------------------------

// MOVS pc, SUBS pc and all other data processing that writes pc with S: CPSR from SPSR.
bool SystemInstructions::exception_return(std::uint32_t w) {
    if (!cpu_.privileged() || cpu_.mode() == arm_mode::SYS) return false;
    const std::uint32_t cpsr = cpu_.cpsr(), pc = cpu_.r()[15] + 4;
    const auto reg = [&](unsigned n, bool by_register) {
        return n == 15 ? pc + (by_register ? 4 : 0) : cpu_.r()[n];
    };
    bool carry = cpsr >> 29 & 1;
    const bool in = carry, by_register = !(w >> 25 & 1) && (w >> 4 & 1);
    const std::uint32_t a = reg(w >> 16 & 0xF, by_register);
    const std::uint32_t b =
        w >> 25 & 1 ? turned(w & 0xFF, w >> 7 & 0x1E)
                    : shifted(reg(w & 0xF, by_register), w >> 5 & 3,
                              by_register ? cpu_.r()[w >> 8 & 0xF] & 0xFF : w >> 7 & 0x1F,
                              by_register, carry);
    std::uint32_t to = 0;
    switch (w >> 21 & 0xF) {
        case 0: to = a & b; break;
        case 1: to = a ^ b; break;
        case 2: to = a - b; break;
        case 3: to = b - a; break;
        case 4: to = a + b; break;
        case 5: to = a + b + in; break;
        case 6: to = a - b - !in; break;
        case 7: to = b - a - !in; break;
        case 12: to = a | b; break;
        case 13: to = b; break;
        case 14: to = a & ~b; break;
        case 15: to = ~b; break;
        default: return false;
    }
    registers_.set_cpsr(cpu_.spsr());
    cpu_.go_to(to);
    return true;
}

// ---- NEON ---------------------------------------------------------------------------------------

bool SystemInstructions::neon(std::uint32_t w, bool in_thumb) {
    if (!cpu_.floating_point()) return false;
    VfpWords& words = cpu_.jit->ExtRegs();
    if (is_newton_step(w, in_thumb)) return newton_step(w, words);
    bool saturated = false;
    const bool done = missed_neon(w, in_thumb, words, saturated);
    if (saturated) cpu_.jit->SetFpscr(cpu_.jit->Fpscr() | FPSCR_QC);
    return done;
}

// ---- Coprocessors -------------------------------------------------------------------------------

// MRC and MCR of coprocessor 15, VMRS and VMSR of VFP's system registers_.
bool SystemInstructions::coprocessor(std::uint32_t w) {
    const bool to_core = w >> 20 & 1;
    const unsigned number = w >> 8 & 0xF, target_reg = w >> 12 & 0xF;
    if (!is(w, 0x0F000010, 0x0E000010)) return false;
    if (is(w, 0x0FE00FFF, 0x0EE00A10)) {
        const unsigned which = w >> 16 & 0xF;
        if (!cpu_.privileged() || !cpu_.may_use_floating_point()) return false;
        if (!to_core) {
            if (which != 8) return which == 0;
            registers_.set_fpexc(cpu_.r()[target_reg]);
            return true;
        }
        switch (which) {
            case 0: cpu_.r()[target_reg] = FPSID; return true;
            case 6: cpu_.r()[target_reg] = MVFR1; return true;
            case 7: cpu_.r()[target_reg] = MVFR0; return true;
            case 8: cpu_.r()[target_reg] = cpu_.fpexc; return true;
            default: return false;
        }
    }
    if (number != 15) return false;
    const Cp15 name{w >> 16 & 0xF, w >> 21 & 7, w & 0xF, w >> 5 & 7};
    if (to_core) {
        const auto value = registers_.read(name, core_.instructions());
        if (!value) return false;
        if (target_reg == 15)
            registers_.set_cpsr((cpu_.cpsr() & 0x0FFFFFFF) | (*value & 0xF0000000));
        else
            cpu_.r()[target_reg] = *value;
        return true;
    }
    return registers_.write(name, target_reg == 15 ? 0 : cpu_.r()[target_reg],
                            core_.instructions());
}

}  // namespace sim
