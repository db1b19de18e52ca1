#include "sim/cpu/dynarmic/instructions.h"

#include "sim/cpu/dynarmic/missed_neon.h"

namespace sim {

namespace {

// Of coprocessor instructions: 10 and 11 are VFP.
unsigned coprocessor(std::uint32_t word) { return word >> 8 & 0xF; }
bool is_vfp(std::uint32_t word) { return (coprocessor(word) & 0xE) == 0xA; }

// MRC and MCR of the thread registers, which translated code executes by itself.
bool is_thread_register(std::uint32_t word) {
    const unsigned op2 = word >> 5 & 7;
    const bool load = word >> 20 & 1;
    return is(word, 0x0FEF0F1F, 0x0E0D0F10) && (word >> 12 & 0xF) != 15 &&
           (op2 == 2 || (op2 == 3 && load));
}

bool is_coprocessors(std::uint32_t word, bool floating_point) {
    const bool status = is(word, 0x0FE00FFF, 0x0EE00A10);  // VMRS and VMSR, of all but FPSCR
    if (is_vfp(word)) return !floating_point || (status && !is(word, 0x000F0000, 0x00010000));
    return !is_thread_register(word);
}

bool is_arm_pli(std::uint32_t w) {
    return is(w, 0xFF30F000, 0xF410F000) || is(w, 0xFF30F010, 0xF610F000);
}

bool is_arm_system(std::uint32_t w, bool floating_point) {
    if (w >> 28 == 0xF) {
        if (is(w, 0xFFF1FE20, 0xF1000000)) return true;                                   // CPS
        if (is(w, 0xFE50FFFF, 0xF8100A00) || is(w, 0xFE5FFFE0, 0xF84D0500)) return true;  // RFE SRS
        if (is_arm_pli(w)) return true;
        return !floating_point &&  // NEON
               (is(w, 0xFE000000, 0xF2000000) || is(w, 0xFF100000, 0xF4000000));
    }
    if (is(w, 0x0FB0FFF0, 0x0120F000)) return (w >> 22 & 1) || (w & 0x30000);  // MSR reg
    if (is(w, 0x0FB0F000, 0x0320F000))                                         // MSR imm, no hint
        return (w >> 22 & 1) || (w & 0x30000);
    if (is(w, 0x0FFF0FFF, 0x014F0000)) return true;  // MRS SPSR
    if (is(w, 0x0E400000, 0x08400000)) return true;  // LDM and STM with ^
    if (is(w, 0x0C10F000, 0x0010F000) && (w >> 23 & 3) != 2 && !is(w, 0x0E000090, 0x00000090))
        return true;                                 // MOVS pc and its kind
    if (is(w, 0x0FD0F0F0, 0x0710F010)) return true;  // SDIV, UDIV
    if (is(w, 0x0FB00E10, 0x0EA00A00)) return true;  // VFMA, VFMS
    if (is(w, 0x0FB00E10, 0x0E900A00)) return true;  // VFNMA, VFNMS
    if (is(w, 0x0C000000, 0x0C000000) && !is(w, 0x0F000000, 0x0F000000))
        return is_coprocessors(w, floating_point);
    return false;
}

bool is_thumb_system(std::uint32_t w, bool floating_point) {
    if (w >> 16 == 0) return is(w, 0xFFE8, 0xB660);                                   // CPS
    if (is(w, 0xFFE0F0FF, 0xF3808000)) return (w >> 20 & 1) || (w & 0x300);           // MSR
    if (is(w, 0xFFEFF0FF, 0xF3EF8000)) return true;                                   // MRS
    if (is(w, 0xFFFFF800, 0xF3AF8000)) return (w & 0x700) != 0;                       // CPS
    if (is(w, 0xFFFFFF00, 0xF3DE8F00)) return true;                                   // SUBS pc, lr
    if (is(w, 0xFFD0FFFF, 0xE810C000) || is(w, 0xFFD0FFFF, 0xE990C000)) return true;  // RFE
    if (is(w, 0xFFDFFFE0, 0xE80DC000) || is(w, 0xFFDFFFE0, 0xE98DC000)) return true;  // SRS
    if (is(w, 0xFFD0F0F0, 0xFB90F0F0)) return true;                                   // SDIV, UDIV
    if (is(w, 0xEF000000, 0xEF000000) || is(w, 0xFF100000, 0xF9000000)) return !floating_point;
    if (!is(w, 0xEC000000, 0xEC000000)) return false;
    if (is(w, 0xFFB00E10, 0xEEA00A00) || is(w, 0xFFB00E10, 0xEE900A00)) return true;  // VFMA ...
    return is_coprocessors(w, floating_point);
}

bool is_arm_branch(std::uint32_t w) {
    if (w >> 28 == 15) return is(w, 0xFE000000, 0xFA000000);
    return is(w, 0x0E000000, 0x0A000000) ||                                      // B, BL, BLX
           is(w, 0x0FFFFFD0, 0x012FFF10) ||                                      // BX, BLX
           is(w, 0x0F000000, 0x0F000000) ||                                      // SVC
           is(w, 0x0E508000, 0x08108000) ||                                      // LDM with pc
           (is(w, 0x0C10F000, 0x0410F000) && !is(w, 0x02000010, 0x02000010)) ||  // LDR pc
           is(w, 0x0FF0FFF0, 0x01A0F000);                                        // MOV pc
}

bool is_thumb_branch(std::uint32_t w) {
    if (w >> 16 == 0)
        return is(w, 0xF000, 0xD000) || is(w, 0xF800, 0xE000) || is(w, 0xFF00, 0x4700) ||
               is(w, 0xFF00, 0xBD00) || is(w, 0xF500, 0xB100);
    if (!is(w, 0xF8008000, 0xF0008000)) return false;
    return (w & 0xD000) != 0x8000 || (w >> 22 & 0xF) < 14;
}

std::uint32_t extended(std::uint32_t value, unsigned bits) {
    const std::uint32_t sign = 1u << (bits - 1);
    return ((value & (2 * sign - 1)) ^ sign) - sign;
}

std::optional<Departure> arm_departure(std::uint32_t w, std::uint32_t pc) {
    if (w >> 28 == 15) {
        if (is(w, 0xFE000000, 0xFA000000)) return Departure{true, {}};  // BLX
        return std::nullopt;
    }
    if (is(w, 0x0E000000, 0x0A000000)) {  // B, BL
        if (w >> 24 & 1) return Departure{true, {}};
        return Departure{false, pc + 8 + (extended(w, 24) << 2)};
    }
    if (is(w, 0x0FFFFFC0, 0x012FFF00)) return Departure{is(w, 0xF0, 0x30), {}};  // BX, BXJ, BLX
    const bool computes =
        is(w, 0x0C00F000, 0x0000F000) && (w >> 23 & 3) != 2 && !is(w, 0x0E000090, 0x00000090);
    const bool loads = is(w, 0x0C10F000, 0x0410F000) && !is(w, 0x02000010, 0x02000010);
    if (computes || loads || is(w, 0x0E108000, 0x08108000)) return Departure{false, {}};
    return std::nullopt;
}

std::optional<Departure> thumb_departure(std::uint32_t w, std::uint32_t pc) {
    if (w >> 16 == 0) {
        if (is(w, 0xF000, 0xD000) && (w >> 8 & 0xF) < 14)
            return Departure{false, pc + 4 + (extended(w, 8) << 1)};
        if (is(w, 0xF800, 0xE000)) return Departure{false, pc + 4 + (extended(w, 11) << 1)};
        if (is(w, 0xF500, 0xB100))  // CBZ, CBNZ
            return Departure{false, pc + 4 + ((w >> 2 & 0x3E) | (w >> 3 & 0x40))};
        if (is(w, 0xFF00, 0x4700)) return Departure{is(w, 0x80, 0x80), {}};  // BX, BLX
        // POP with pc, ADD and MOV to pc.
        if (is(w, 0xFF00, 0xBD00) || is(w, 0xFD87, 0x4487)) return Departure{false, {}};
        return std::nullopt;
    }
    if (is(w, 0xF8008000, 0xF0008000)) {
        if (w & 0x4000) return Departure{true, {}};  // BL, BLX
        const std::uint32_t s = w >> 26 & 1, j1 = w >> 13 & 1, j2 = w >> 11 & 1;
        if (w & 0x1000)
            return Departure{false, pc + 4 +
                                        extended(s << 24 | (s == j1) << 23 | (s == j2) << 22 |
                                                     (w >> 16 & 0x3FF) << 12 | (w & 0x7FF) << 1,
                                                 25)};
        if ((w >> 22 & 0xF) >= 14) return std::nullopt;
        return Departure{false, pc + 4 +
                                    extended(s << 20 | j2 << 19 | j1 << 18 |
                                                 (w >> 16 & 0x3F) << 12 | (w & 0x7FF) << 1,
                                             21)};
    }
    if (is(w, 0xFE508000, 0xE8108000) || is(w, 0xFF70F000, 0xF850F000))  // LDM, LDR
        return Departure{false, {}};
    return std::nullopt;
}

}  // namespace

std::optional<Departure> departure(std::uint32_t word, bool thumb, std::uint32_t pc) {
    return thumb ? thumb_departure(word, pc) : arm_departure(word, pc);
}

bool is_system(std::uint32_t word, bool thumb, bool floating_point) {
    if (is_absent(word, thumb) || loads_its_base(word, thumb)) return true;
    if (is_unprivileged(word, thumb) || (!thumb && is_swap(word))) return true;
    if (is_newton_step(word, thumb) || is_missed_neon(word, thumb)) return true;
    return thumb ? is_thumb_system(word, floating_point) : is_arm_system(word, floating_point);
}

bool loads_its_base(std::uint32_t w, bool thumb) {
    if (thumb && w >> 16 == 0) return is(w, 0xF800, 0xC800) && (w >> (w >> 8 & 7) & 1);
    const bool multiple = thumb ? is(w, 0xFFF00000, 0xE8900000) || is(w, 0xFFF00000, 0xE9100000)
                                : is(w, 0x0E700000, 0x08100000) && w >> 28 != 15;
    return multiple && (w >> (w >> 16 & 0xF) & 1) && (w >> 16 & 0xF) != 15;
}

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

bool is_newton_step(std::uint32_t w, bool thumb) {
    return is(w, 0xFF900F10, thumb ? 0xEF000F10 : 0xF2000F10);
}

bool is_branch(std::uint32_t word, bool thumb) {
    return thumb ? is_thumb_branch(word) : is_arm_branch(word);
}

bool is_it(std::uint32_t word) { return is(word, 0xFFFFFF00, 0xBF00) && (word & 0xF) != 0; }

unsigned it_state(std::uint32_t cpsr) { return (cpsr >> 8 & 0xFC) | (cpsr >> 25 & 3); }

std::uint32_t with_it_state(std::uint32_t cpsr, unsigned it) {
    constexpr std::uint32_t IT = 0x0600FC00;
    return (cpsr & ~IT) | (it & 0xFC) << 8 | (it & 3) << 25;
}

unsigned next_it(unsigned it) { return it & 7 ? (it & 0xE0) | (it << 1 & 0x1F) : 0; }

std::uint32_t shifted(std::uint32_t value, unsigned type, unsigned amount, bool by_register,
                      bool& carry) {
    if (amount == 0 && by_register) return value;
    if (amount == 0 && type == 0) return value;
    if (amount == 0 && type == 3) {  // RRX
        const bool in = carry;
        carry = value & 1;
        return value >> 1 | static_cast<std::uint32_t>(in) << 31;
    }
    if (amount == 0) amount = 32;
    switch (type) {
        case 0:
            carry = amount <= 32 && (value >> (32 - amount) & 1);
            return amount < 32 ? value << amount : 0;
        case 1:
            carry = amount <= 32 && (value >> (amount - 1) & 1);
            return amount < 32 ? value >> amount : 0;
        case 2: {
            const unsigned by = amount < 32 ? amount : 31;
            carry = amount < 32 ? value >> (amount - 1) & 1 : value >> 31;
            return static_cast<std::uint32_t>(static_cast<std::int32_t>(value) >> by);
        }
        default: {
            const unsigned by = amount & 31;
            const std::uint32_t turned = by ? value >> by | value << (32 - by) : value;
            carry = turned >> 31;
            return turned;
        }
    }
}

std::optional<WriteBack> early_write_back(std::uint32_t w, bool thumb, const std::uint32_t* r,
                                          bool carry, std::uint32_t address) {
    const unsigned base = w >> 16 & 0xF;
    const bool up = w >> 23 & 1;
    const auto by = [&](std::uint32_t offset) { return WriteBack{base, up ? offset : -offset}; };

    // VLDM, VSTM, VPUSH, VPOP with !
    const bool vfp_multiple =
        is(w, 0x0E200E00, 0x0C200A00) && (thumb ? w >> 28 == 0xE : w >> 28 != 0xF);
    if (vfp_multiple) return by(4 * (w & 0xFF));
    // LDM and STM with ! and pc: before pc's access, which is the last.
    const bool multiple = thumb ? is(w, 0xFE508000, 0xE8108000) : is(w, 0x0E408000, 0x08008000);
    if (multiple && (w >> 21 & 1) && (thumb || w >> 28 != 0xF)) {
        const bool done = up ? address < r[base] + (w >> 24 & 1) : address >= r[base];
        return done ? std::optional{by(4 * bits_of(w & 0xFFFF))} : std::nullopt;
    }
    if (thumb || w >> 28 == 0xF) return std::nullopt;

    const bool pre = w >> 24 & 1, write = w >> 21 & 1;
    if (pre && !write) return std::nullopt;
    if (is(w, 0x0C000000, 0x04000000)) {
        if (!(w >> 25 & 1)) return by(w & 0xFFF);
        if (w >> 4 & 1) return std::nullopt;  // media instructions
        return by(shifted(r[w & 0xF], w >> 5 & 3, w >> 7 & 0x1F, false, carry));
    }
    const bool extra = is(w, 0x0E000090, 0x00000090) && (w & 0x60) != 0;
    if (!extra) return std::nullopt;
    return by(w >> 22 & 1 ? (w >> 4 & 0xF0) | (w & 0xF) : r[w & 0xF]);
}

bool condition_holds(unsigned cond, std::uint32_t cpsr) {
    const bool n = cpsr >> 31, z = cpsr >> 30 & 1, c = cpsr >> 29 & 1, v = cpsr >> 28 & 1;
    bool holds = true;
    switch (cond >> 1) {
        case 0: holds = z; break;
        case 1: holds = c; break;
        case 2: holds = n; break;
        case 3: holds = v; break;
        case 4: holds = c && !z; break;
        case 5: holds = n == v; break;
        case 6: holds = !z && n == v; break;
        default: return true;
    }
    return holds != ((cond & 1) != 0);
}

}  // namespace sim
