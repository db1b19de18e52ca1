// steady_thumb.cpp - SteadyLoop's instructions of Thumb: most are those of ARM in another encoding
#include "sim/cpu/steady_arithmetic.h"
#include "sim/cpu/steady_loop.h"

namespace sim {

using namespace steady;

namespace {

constexpr std::uint32_t AL = 0xE0000000, SETS = 1u << 20;
constexpr unsigned SP = 13;

constexpr std::uint32_t name(unsigned number, unsigned lowest) { return number << lowest; }

// ARM's data processing, by the number of the operation, of registers.
constexpr std::uint32_t operation(unsigned number, bool sets, unsigned n, unsigned d, unsigned m) {
    return AL | number << 21 | (sets ? SETS : 0) | name(n, 16) | name(d, 12) | m;
}
constexpr std::uint32_t with_immediate(unsigned number, bool sets, unsigned n, unsigned d,
                                       unsigned immediate) {
    return operation(number, sets, n, d, 0) | 1u << 25 | immediate;
}
constexpr std::uint32_t TIMES_4 = 15 << 8;  // an immediate, turned left by 2

// ARM's load or store of `bytes` by the given base, at an offset of 8 or, for words and bytes, 12
// bits.
constexpr std::uint32_t half(unsigned offset) {
    return 0x004000B0 | (offset & 0xF0) << 4 | (offset & 0xF);
}

// The number that a Thumb instruction's 12 bits stand for, and the carry that they leave.
std::uint32_t expanded(std::uint32_t twelve, int& carry) {
    const std::uint32_t byte = twelve & 0xFF;
    switch (twelve >> 8) {
        case 0: return byte;
        case 1: return byte << 16 | byte;
        case 2: return byte << 24 | byte << 8;
        case 3: return byte << 24 | byte << 16 | byte << 8 | byte;
        default: return shift(0x80 | (twelve & 0x7F), 3, twelve >> 7, carry);
    }
}

}  // namespace

bool SteadyLoop::execute_thumb(std::uint32_t word, World& world) {
    if (matches(word, 0xFFFFFF00, 0x0000BF00) && (word & 0xF)) {  // IT
        if (in_it()) return false;
        it_ = word & 0xFF;
        return true;
    }
    bool taken = true;
    if (in_it() && it_ >> 4 != ALWAYS) {
        const std::optional<bool> met = holds(it_ >> 4);
        if (!met) return false;
        taken = *met;
    }
    if (taken && !(word <= 0xFFFF ? thumb_16(word, world) : thumb_32(word, world))) return false;
    if (in_it()) it_ = (it_ & 0xE0) | (it_ << 1 & 0x1F);
    return true;
}

bool SteadyLoop::thumb_16(std::uint32_t w, World& world) {
    const unsigned d = w & 7, n = bits(w, 5, 3), m = bits(w, 8, 6), high = bits(w, 10, 8);
    const unsigned five = bits(w, 10, 6), eight = w & 0xFF;
    const bool sets = !in_it(), upper = w >> 11 & 1;
    const std::uint32_t load = upper ? SETS : 0;
    const auto as_arm = [&](std::uint32_t arm) { return execute_arm(AL | arm, world); };
    switch (w >> 12) {
        case 0:
        case 1:
            if (bits(w, 12, 11) != 3)
                return as_arm(operation(MOV, sets, 0, d, n) | five << 7 | bits(w, 12, 11) << 5);
            if (w >> 10 & 1) return as_arm(with_immediate(w >> 9 & 1 ? SUB : ADD, sets, n, d, m));
            return as_arm(operation(w >> 9 & 1 ? SUB : ADD, sets, n, d, m));
        case 2:
            return as_arm(upper ? with_immediate(CMP, true, high, 0, eight)
                                : with_immediate(MOV, sets, 0, high, eight));
        case 3: return as_arm(with_immediate(upper ? SUB : ADD, sets, high, high, eight));
        case 4: {
            if (upper) return as_arm(0x05900000 | name(PC, 16) | name(high, 12) | eight << 2);
            if (w >> 10 & 1) {  // also of the high registers
                const unsigned to = (w >> 4 & 8) | d, from = bits(w, 6, 3);
                const unsigned kind = bits(w, 9, 8);
                if (kind == 3) return (w & 7) == 0 && as_arm(0x012FFF10 | (w >> 2 & 0x20) | from);
                if (to == PC || from == PC) return false;
                if (kind == 0) return as_arm(operation(ADD, false, to, to, from));
                return as_arm(kind == 1 ? operation(CMP, true, to, 0, from)
                                        : operation(MOV, false, 0, to, from));
            }
            constexpr unsigned SHIFTS = 1u << 2 | 1u << 3 | 1u << 4 | 1u << 7;
            constexpr unsigned AS_ARM[] = {AND, EOR, MOV, MOV, MOV, ADC, SBC, MOV,
                                           TST, RSB, CMP, CMN, ORR, 0,   BIC, MVN};
            const unsigned kind = bits(w, 9, 6);
            if (SHIFTS >> kind & 1) {
                const unsigned type = kind == 7 ? 3 : kind - 2;
                return as_arm(operation(MOV, sets, 0, d, d) | name(n, 8) | type << 5 | 0x10);
            }
            if (kind == 9) return as_arm(with_immediate(RSB, sets, n, d, 0));
            if (kind == 13) return as_arm((sets ? SETS : 0) | name(d, 16) | name(n, 8) | 0x90 | d);
            const bool tests = kind == 8 || kind == 10 || kind == 11;
            return as_arm(
                operation(AS_ARM[kind], sets || tests, kind == 15 ? 0 : d, tests ? 0 : d, n));
        }
        case 5: {
            constexpr std::uint32_t KINDS[] = {0x07800000, 0x018000B0, 0x07C00000, 0x019000D0,
                                               0x07900000, 0x019000B0, 0x07D00000, 0x019000F0};
            return as_arm(KINDS[bits(w, 11, 9)] | name(n, 16) | name(d, 12) | m);
        }
        case 6: return as_arm(0x05800000 | load | name(n, 16) | name(d, 12) | five << 2);
        case 7: return as_arm(0x05C00000 | load | name(n, 16) | name(d, 12) | five);
        case 8: return as_arm(0x01800000 | load | name(n, 16) | name(d, 12) | half(2 * five));
        case 9: return as_arm(0x05800000 | load | name(SP, 16) | name(high, 12) | eight << 2);
        case 10: return as_arm(with_immediate(ADD, false, upper ? SP : PC, high, TIMES_4 | eight));
        case 11: {
            if (matches(w, 0xFF00, 0xB000))
                return as_arm(
                    with_immediate(w >> 7 & 1 ? SUB : ADD, false, SP, SP, TIMES_4 | (w & 0x7F)));
            if (matches(w, 0xFF00, 0xB200)) {
                constexpr std::uint32_t KINDS[] = {0x06BF0070, 0x06AF0070, 0x06FF0070, 0x06EF0070};
                return as_arm(KINDS[bits(w, 7, 6)] | name(d, 12) | n);
            }
            if (matches(w, 0xFE00, 0xB400))
                return as_arm(0x092D0000 | name(w >> 8 & 1, LINK) | eight);
            if (matches(w, 0xFE00, 0xBC00))
                return as_arm(0x08BD0000 | name(w >> 8 & 1, PC) | eight);
            if (matches(w, 0xFFEF, 0xBF00)) return true;  // NOP, YIELD
            return matches(w, 0xF500, 0xB100) && thumb_branch(w);
        }
        case 12: {
            const bool write_back = !upper || !(eight >> high & 1);
            return as_arm(0x08800000 | (write_back ? 1u << 21 : 0) | load | name(high, 16) | eight);
        }
        case 13:
        case 14: return thumb_branch(w);
        default: return false;
    }
}

// Of both lengths; also CBZ and CBNZ.
bool SteadyLoop::thumb_branch(std::uint32_t w) {
    if (w <= 0xFFFF && w >> 12 == 11) {
        const Linear value = read(w & 7);
        limit(rounds_zero(value));
        const bool taken = (value.base == 0) != (w >> 11 & 1);
        return !taken || branch((w >> 3 & 0x40) | (w >> 2 & 0x3E), false);
    }
    if (w <= 0xFFFF && w >> 12 == 14)
        return !(w >> 11 & 1) && branch(extended(w & 0x7FF, 11) << 1, false);
    const bool longer = w > 0xFFFF, any = longer && (w >> 12 & 1);
    if (!any) {
        const unsigned condition = longer ? bits(w, 25, 22) : bits(w, 11, 8);
        if (condition >= ALWAYS) return false;
        const std::optional<bool> taken = holds(condition);
        if (!taken) return false;
        if (!*taken) return true;
        if (!longer) return branch(extended(w & 0xFF, 8) << 1, false);
    }
    const unsigned s = w >> 26 & 1, j1 = w >> 13 & 1, j2 = w >> 11 & 1;
    const std::uint32_t low = bits(w, 10, 0);
    if (!any)
        return branch(
            extended(s << 19 | j2 << 18 | j1 << 17 | bits(w, 21, 16) << 11 | low, 20) << 1, false);
    const unsigned i1 = !(j1 ^ s), i2 = !(j2 ^ s);
    const std::uint32_t offset = s << 23 | i1 << 22 | i2 << 21 | bits(w, 25, 16) << 11 | low;
    return branch(extended(offset, 24) << 1, w >> 14 & 1);
}

bool SteadyLoop::thumb_32(std::uint32_t w, World& world) {
    const unsigned n = bits(w, 19, 16), d = bits(w, 11, 8), m = w & 0xF;
    const auto as_arm = [&](std::uint32_t arm) { return execute_arm(AL | arm, world); };
    if (matches(w, 0xF8008000, 0xF0008000)) {
        if (w == 0xF3AF8000 || matches(w, 0xFFFFFF00, 0xF3BF8F00)) return true;  // NOP, barriers
        const bool branches = matches(w, 0x5000, 0x1000) || matches(w, 0x5000, 0x5000) ||
                              (matches(w, 0x5000, 0) && bits(w, 25, 23) != 7);
        return branches && thumb_branch(w);
    }
    if (matches(w, 0xF8008000, 0xF0000000) || matches(w, 0xFE000000, 0xEA000000))
        return thumb_data(w);
    if (matches(w, 0xFE400000, 0xE8000000)) {  // of several registers
        const bool before = w >> 24 & 1, up = w >> 23 & 1;
        return before != up && as_arm(0x08000000 | (w & 0x01BFFFFF));
    }
    if (matches(w, 0xFE400000, 0xE8400000) || matches(w, 0xFE000000, 0xF8000000))
        return thumb_transfer(w, world);
    if (matches(w, 0xFF80F0F0, 0xFA00F000))  // shifts by a register
        return as_arm(operation(MOV, w >> 20 & 1, 0, d, n) | name(m, 8) | bits(w, 22, 21) << 5 |
                      0x10);
    if (matches(w, 0xFF8FF0C0, 0xFA0FF080)) {
        constexpr std::uint32_t KINDS[] = {0x06BF0070, 0x06FF0070, 0, 0, 0x06AF0070, 0x06EF0070};
        const unsigned kind = bits(w, 22, 20);
        return kind < 6 && KINDS[kind] &&
               as_arm(KINDS[kind] | name(d, 12) | bits(w, 5, 4) << 10 | m);
    }
    if (matches(w, 0xFFF000F0, 0xFB000000)) {  // MUL, MLA
        const unsigned more = bits(w, 15, 12);
        const std::uint32_t adds = more == 15 ? 0 : 1u << 21 | name(more, 12);
        return as_arm(adds | name(d, 16) | name(m, 8) | 0x90 | n);
    }
    return matches(w, 0xFFFF0FFF, 0xEE190F1D) && as_arm(w & 0x0FFFFFFF);
}

bool SteadyLoop::thumb_data(std::uint32_t w) {
    constexpr unsigned NONE = 16;
    constexpr unsigned AS_ARM[] = {AND, BIC,  ORR, NONE, EOR,  NONE, NONE, NONE,
                                   ADD, NONE, ADC, SBC,  NONE, SUB,  RSB,  NONE};
    const unsigned n = bits(w, 19, 16), d = bits(w, 11, 8), kind = bits(w, 24, 21);
    const std::uint32_t twelve = (w >> 15 & 0x800) | (w >> 4 & 0x700) | (w & 0xFF);
    const bool immediate = w >> 28 == 15, sets = w >> 20 & 1;
    if (immediate && w >> 25 & 1) {
        const std::uint32_t sixteen = n << 12 | twelve;
        const unsigned low = (w >> 10 & 0x1C) | bits(w, 7, 6);
        switch (bits(w, 24, 20)) {
            case 0x00: return d != PC && write(d, read(n) + fixed(twelve));
            case 0x0A: return d != PC && write(d, read(n) - fixed(twelve));
            case 0x04: return d != PC && write(d, fixed(sixteen));
            case 0x0C: return miscellaneous(AL | 0x03400000 | n << 16 | name(d, 12) | twelve);
            case 0x14:
            case 0x1C:
                return media(AL | 0x07A00050 | (w >> 23 & 1 ? 1u << 22 : 0) | (w & 0x1F) << 16 |
                             name(d, 12) | low << 7 | n);
            default: return false;
        }
    }
    int carry = UNCHANGED;
    std::optional<Linear> second;
    if (immediate)
        second = fixed(expanded(twelve, carry));
    else
        second = shifted((w & 0xF) | bits(w, 5, 4) << 5 | ((w >> 10 & 0x1C) | bits(w, 7, 6)) << 7,
                         carry);
    if (!second) return false;
    unsigned number = AS_ARM[kind];
    if (n == PC && (kind == 2 || kind == 3)) number = kind == 2 ? MOV : MVN;
    if (number == NONE) return false;
    if (d == PC) {
        if (!sets) return false;
        if (number != AND && number != EOR && number != ADD && number != SUB) return false;
        number = number == AND ? TST : number == EOR ? TEQ : number == ADD ? CMN : CMP;
    }
    const bool alone = number == MOV || number == MVN;
    return operate(number, sets, d, alone ? fixed(0) : read(n), *second, carry);
}

bool SteadyLoop::thumb_transfer(std::uint32_t w, World& world) {
    const unsigned n = bits(w, 19, 16), t = bits(w, 15, 12), eight = w & 0xFF;
    const bool load = w >> 20 & 1;
    if (w >> 28 == 14) {  // of two registers
        const bool pre = w >> 24 & 1, up = w >> 23 & 1, write_back = w >> 21 & 1;
        const unsigned second = bits(w, 11, 8);
        if ((!pre && !write_back) || t == PC || second == PC) return false;
        if (n == t || (write_back && (n == second || n == PC))) return false;
        const Linear to = up ? read(n) + fixed(4 * eight) : read(n) - fixed(4 * eight);
        const Linear address = pre ? to : read(n);
        return transfer(load, 4, false, t, address, world) &&
               transfer(load, 4, false, second, address + fixed(4), world) &&
               (!write_back || write(n, to));
    }
    const unsigned size = bits(w, 22, 21);
    const bool is_signed = w >> 24 & 1, longer = w >> 23 & 1;
    if (size == 3 || (is_signed && (!load || size == 2))) return false;
    if (t == PC && size != 2) return false;  // hints to the cache
    const auto at = [&](const Linear& address) {
        return transfer(load, 1u << size, is_signed, t, address, world);
    };
    const Linear base = read(n);
    if (n == PC) return load && at(longer ? base + fixed(w & 0xFFF) : base - fixed(w & 0xFFF));
    if (longer) return at(base + fixed(w & 0xFFF));
    if (matches(w, 0xFC0, 0)) {
        int carry = UNCHANGED;
        const std::optional<Linear> offset = shifted((w & 0xF) | bits(w, 5, 4) << 7, carry);
        return offset && at(base + *offset);
    }
    const bool pre = w >> 10 & 1, up = w >> 9 & 1, write_back = w >> 8 & 1;
    if (!(w >> 11 & 1) || (!pre && !write_back) || (pre && up && !write_back)) return false;
    if (write_back && n == t) return false;
    const Linear to = up ? base + fixed(eight) : base - fixed(eight);
    return at(pre ? to : base) && (!write_back || write(n, to));
}

}  // namespace sim
