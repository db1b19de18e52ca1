#include "sim/cpu/steady_loop.h"

#include <algorithm>

#include "sim/cpu/steady_arithmetic.h"

namespace sim {

using namespace steady;

// ---- Rounds -------------------------------------------------------------------------------------

bool SteadyLoop::follow(const Registers& registers, World& world) {
    first_flags_ = {};
    return two_passes(registers, world);
}

bool SteadyLoop::follow_with_flags(const Registers& registers, World& world) {
    first_flags_ = {false, {}, {}, N | Z | C | V, registers.cpsr >> 28};
    return two_passes(registers, world);
}

// In the first pass all values are those of this round, so what grows is seen at its end.  In the
// second they grow by these amounts, and must again.
bool SteadyLoop::two_passes(const Registers& registers, World& world) {
    ahead_.reset();
    cpsr_ = registers.cpsr;
    thumb_ = cpsr_ & THUMB;
    if (cpsr_ & STATE) return false;
    word_count_ = 0;
    round_instructions_ = 0;
    round_ps_ = 0;
    for (unsigned i = 0; i < 16; ++i) begin_[i] = fixed(registers.r[i]);
    if (!pass(world)) return false;
    round_instructions_ = instructions_;
    if (counts_) {
        round_ps_ = world.round_ps(uses_.data(), use_count_, instructions_);
        if (round_ps_ == 0) return false;
    }
    for (unsigned i = 0; i < PC; ++i) begin_[i].step = r_[i].base - begin_[i].base;
    for (unsigned i = 0; i < word_count_; ++i)
        words_[i].value.step = now_[i].base - words_[i].value.base;
    if (!pass(world)) return false;
    const auto grows = [](const Linear& begin, const Linear& end, bool is_read) {
        return !end.unknown && (!is_read || end == Linear{begin.base + begin.step, begin.step});
    };
    read_ |= ~written_;
    words_read_ |= ~words_written_;
    for (unsigned i = 0; i < PC; ++i)
        if (!grows(begin_[i], r_[i], read_ >> i & 1)) return false;
    for (unsigned i = 0; i < word_count_; ++i)
        if (!grows(words_[i].value, now_[i], words_read_ >> i & 1)) return false;
    return true;
}

bool SteadyLoop::pass(World& world) {
    r_ = begin_;
    for (unsigned i = 0; i < word_count_; ++i) now_[i] = words_[i].value;
    flags_ = first_flags_;
    flags_missing_ = false;
    use_count_ = instructions_ = 0;
    read_ = written_ = words_read_ = words_written_ = 0;
    counts_ = false;
    it_ = 0;
    rounds_ = ALL_ROUNDS;
    const std::uint32_t begin = begin_[PC].base;
    std::uint32_t lowest = begin, highest = begin;
    for (pc_ = begin; instructions_ < MOST; pc_ = next_) {
        const std::optional<std::uint32_t> word = world.code(pc_, thumb_);
        if (!word) return false;
        ++instructions_;
        next_ = pc_ + (thumb_ && *word <= 0xFFFF ? 2 : 4);
        lowest = std::min(lowest, pc_ & ~3u);
        highest = std::max(highest, pc_ + 2);
        if (!(thumb_ ? execute_thumb(*word, world) : execute(*word, world))) {
            if (flags_missing_ && !ahead_ && !in_it()) ahead_ = instructions_;
            return false;
        }
        if (next_ == begin && !in_it()) {
            for (unsigned i = 0; i < word_count_; ++i)
                if (words_[i].address - lowest <= highest - lowest) return false;
            return true;
        }
        if (next_ < pc_ && !ahead_) ahead_ = instructions_;
    }
    return false;
}

SteadyLoop::Registers SteadyLoop::after(std::uint64_t n) const {
    Registers registers{{}, cpsr_};
    for (unsigned i = 0; i < PC; ++i) registers.r[i] = after(begin_[i], r_[i], read_ >> i & 1, n);
    registers.r[PC] = begin_[PC].base;
    return registers;
}

// ---- Instructions: false if the round cannot be followed ----------------------------------------

bool SteadyLoop::execute(std::uint32_t word, World& world) {
    const unsigned condition = word >> 28;
    if (condition == SPECIAL)  // DSB, DMB, ISB, PLD
        return matches(word, 0xFFFFFF00, 0xF57FF000) || matches(word, 0xFD70F000, 0xF550F000);
    if (condition != ALWAYS) {
        const std::optional<bool> taken = holds(condition);
        if (!taken) return false;
        if (!*taken) return true;
    }
    return execute_arm(word, world);
}

// Whatever its condition.
bool SteadyLoop::execute_arm(std::uint32_t word, World& world) {
    switch (bits(word, 27, 25)) {
        case 0:
            if (matches(word, 0x90, 0x90)) return extra_transfer(word, world);
            [[fallthrough]];
        case 1:
            if (matches(word, 0x01900000, 0x01000000)) return miscellaneous(word);
            return data_processing(word);
        case 3:
            if (word & 0x10) return media(word);
            [[fallthrough]];
        case 2: return single_transfer(word, world);
        case 4: return block_transfer(word, world);
        case 5: return branch(extended(bits(word, 23, 0), 24) << 2, word >> 24 & 1);
        case 7:
            if (matches(word, 0x0FFF0FFF, 0x0E190F1D))
                return cycle_counter(bits(word, 15, 12), world);
            return false;
        default: return false;
    }
}

bool SteadyLoop::branch(std::uint32_t offset, bool link) {
    if (link) write(LINK, fixed(next_ | thumb_));
    next_ = pc_ + (thumb_ ? 4 : 8) + offset;
    return true;
}

// MRC of PMCCNTR.
bool SteadyLoop::cycle_counter(unsigned target, World& world) {
    const std::optional<World::Cycles> cycles = world.cycles(instructions_);
    if (!cycles || target == PC) return false;
    return write(target, {cycles->value, cycles->step * round_instructions_});
}

Linear SteadyLoop::read(unsigned number) {
    if (number == PC) return fixed(thumb_ ? (pc_ + 4) & ~3u : pc_ + 8);
    if (!(written_ >> number & 1)) read_ |= 1u << number;
    return r_[number];
}

bool SteadyLoop::write(unsigned number, const Linear& value) {
    if (number != PC) {
        written_ |= 1u << number;
        r_[number] = value;
        return true;
    }
    if (!value.fixed() || (thumb_ ? value.base % 2 != 1 : value.base % 4 != 0)) return false;
    next_ = value.base & ~1u;
    return true;
}

std::optional<Linear> SteadyLoop::shifted(std::uint32_t word, int& carry) {
    const Linear value = read(word & 0xF);
    const unsigned type = bits(word, 6, 5);
    unsigned amount = bits(word, 11, 7);
    if (word & 0x10) {
        const Linear by = read(bits(word, 11, 8));
        if (!by.fixed() || !value.fixed()) return std::nullopt;
        return fixed(shift(value.base, type, by.base & 0xFF, carry));
    }
    if (type == 0 && amount == 0) return value;
    if (!value.fixed()) {
        if (type != 0 || !value.is_line()) return std::nullopt;
        carry = UNKNOWN;
        return Linear{value.base << amount, value.step << amount};
    }
    if (amount == 0) {
        if (type == 3) return std::nullopt;  // RRX
        amount = 32;
    }
    return fixed(shift(value.base, type, amount, carry));
}

bool SteadyLoop::data_processing(std::uint32_t word) {
    int carry = UNCHANGED;
    std::optional<Linear> second;
    if (word >> 25 & 1) {
        const unsigned turn = 2 * bits(word, 11, 8);
        second = fixed(shift(word & 0xFF, 3, turn, carry));
    } else {
        second = shifted(word, carry);
    }
    if (!second) return false;
    const bool sets = word >> 20 & 1;
    const unsigned target = bits(word, 15, 12);
    if (sets && target == PC) return false;  // a return from an exception
    return operate(bits(word, 24, 21), sets, target, read(bits(word, 19, 16)), *second, carry);
}

void SteadyLoop::set_logical(const Linear& result, int carry) {
    if (!result.fixed()) {
        flags_ = {true, result, fixed(0), N | Z, 0};
        return;
    }
    unsigned known = flags_.compared ? 0 : flags_.known & (C | V);
    unsigned nzcv = flags_.nzcv & known;
    if (carry != UNCHANGED) {
        known &= ~C;
        nzcv &= ~C;
        if (carry != UNKNOWN) {
            known |= C;
            nzcv |= carry ? C : 0;
        }
    }
    nzcv |= (result.base >> 31 ? N : 0) | (result.base == 0 ? Z : 0);
    flags_ = {false, {}, {}, known | N | Z, nzcv};
}

bool SteadyLoop::operate(unsigned operation, bool sets, unsigned target, Linear a, Linear b,
                         int carry) {
    const bool only_tests = operation >= TST && operation <= CMN;
    if (operation == RSB || operation == RSC) {
        std::swap(a, b);
        operation = operation == RSB ? SUB : SBC;
    }
    Linear result;
    switch (operation) {
        case SUB:
        case CMP:
            result = a - b;
            if (!sets) break;
            if (a.fixed() && b.fixed())
                flags_ = {false, {}, {}, N | Z | C | V, flags_of_sum(a.base, ~b.base, 1)};
            else
                flags_ = {true, a, b, N | Z | C | V, 0};
            break;
        case ADD:
        case CMN:
            result = a + b;
            if (!sets) break;
            if (a.fixed() && b.fixed())
                flags_ = {false, {}, {}, N | Z | C | V, flags_of_sum(a.base, b.base, 0)};
            else
                flags_ = {true, result, fixed(0), N | Z, 0};
            break;
        case ADC:
        case SBC: {
            const std::optional<bool> in = holds(2);
            if (!in || !a.fixed() || !b.fixed()) return false;
            const std::uint32_t second = operation == ADC ? b.base : ~b.base;
            result = fixed(a.base + second + *in);
            if (sets) flags_ = {false, {}, {}, N | Z | C | V, flags_of_sum(a.base, second, *in)};
            break;
        }
        case MOV:
            result = b;
            if (sets) set_logical(result, carry);
            break;
        case MVN:
            result = fixed(~0u) - b;
            if (sets) set_logical(result, carry);
            break;
        default: {
            if (!a.fixed() || !b.fixed()) return false;
            const std::uint32_t x = a.base, y = b.base;
            result = fixed(operation == AND || operation == TST   ? x & y
                           : operation == EOR || operation == TEQ ? x ^ y
                           : operation == ORR                     ? x | y
                                                                  : x & ~y);
            if (sets) set_logical(result, carry);
        }
    }
    return only_tests || write(target, result);
}

// The condition in this round; it limits the rounds to those in which it comes out the same.
std::optional<bool> SteadyLoop::holds(unsigned condition) {
    constexpr unsigned NEEDED[] = {Z, C, N, V, C | Z, N | V, N | Z | V};
    const unsigned pair = condition / 2;
    if ((flags_.known & NEEDED[pair]) != NEEDED[pair]) {
        flags_missing_ = true;
        return std::nullopt;
    }
    bool result;
    if (!flags_.compared) {
        const unsigned f = flags_.nzcv;
        const bool less = ((f & N) != 0) != ((f & V) != 0);
        const bool all[] = {(f & Z) != 0,        (f & C) != 0, (f & N) != 0,     (f & V) != 0,
                            (f & C) && !(f & Z), !less,        !less && !(f & Z)};
        result = all[pair];
    } else {
        const Linear &a = flags_.a, &b = flags_.b, difference = a - b;
        const auto sa = static_cast<std::int32_t>(a.base), sb = static_cast<std::int32_t>(b.base);
        switch (pair) {
            case 0:
                result = difference.base == 0;
                limit(rounds_zero(difference));
                break;
            case 1:
                result = a.base >= b.base;
                limit(rounds_below(a, b));
                break;
            case 2:
                result = difference.base >> 31;
                limit(rounds_sign(difference));
                break;
            case 4:
                result = a.base > b.base;
                limit(rounds_below(b, a));
                break;
            case 5:
                result = sa >= sb;
                limit(rounds_less(a, b));
                break;
            case 6:
                result = sa > sb;
                limit(rounds_less(b, a));
                break;
            default: return std::nullopt;
        }
    }
    return result != (condition & 1);
}

bool SteadyLoop::miscellaneous(std::uint32_t word) {
    const unsigned target = bits(word, 15, 12);
    const std::uint32_t immediate = bits(word, 19, 16) << 12 | bits(word, 11, 0);
    if (matches(word, 0x0FF00000, 0x03000000)) return write(target, fixed(immediate));  // MOVW
    if (matches(word, 0x0FF00000, 0x03400000)) {                                        // MOVT
        if (!read(target).fixed()) return false;
        return write(target, fixed((read(target).base & 0xFFFF) | immediate << 16));
    }
    if (matches(word, 0x0FFFFFFE, 0x0320F000)) return true;  // NOP, YIELD
    const bool link = matches(word, 0x0FFFFFF0, 0x012FFF30);
    if (link || matches(word, 0x0FFFFFF0, 0x012FFF10)) {  // BLX, BX
        const Linear to = read(word & 0xF);
        if (link) write(LINK, fixed(next_ | thumb_));
        return write(PC, to);
    }
    return false;
}

// Of bytes and halfwords that lie in registers, and fields of bits.
bool SteadyLoop::media(std::uint32_t word) {
    const unsigned target = bits(word, 15, 12);
    const Linear source = read(word & 0xF);
    if (!source.fixed()) return false;
    if (matches(word, 0x0FAF03F0, 0x06AF0070)) {  // SXTB, UXTB, SXTH, UXTH
        int carry = UNCHANGED;
        const std::uint32_t turned = shift(source.base, 3, 8 * bits(word, 11, 10), carry);
        const unsigned width = word >> 20 & 1 ? 16 : 8;
        const std::uint32_t value = turned & ((1u << width) - 1);
        return write(target, fixed(word >> 22 & 1 ? value : extended(value, width)));
    }
    if (matches(word, 0x0FA00070, 0x07A00050)) {  // SBFX, UBFX
        const unsigned low = bits(word, 11, 7), width = bits(word, 20, 16) + 1;
        if (low + width > 32) return false;
        const std::uint32_t value = bits(source.base, low + width - 1, low);
        return write(target, fixed(word >> 22 & 1 ? value : extended(value, width)));
    }
    return false;
}

}  // namespace sim
