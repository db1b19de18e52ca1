#include "tb/sim/arm_core/system_items.h"

#include <iterator>

#include "sim/cpu/arm_core.h"

namespace tb::core {

namespace {

using sim::Cp15;
using Word = std::uint32_t;
namespace cpsr = sim::arm_cpsr;
constexpr Word USR = sim::arm_mode::USR, FIQ = sim::arm_mode::FIQ, SVC = sim::arm_mode::SVC,
               SYS = sim::arm_mode::SYS;
constexpr Word MODES[]{sim::arm_mode::IRQ, sim::arm_mode::ABT, sim::arm_mode::UND, FIQ, SVC, SYS};
constexpr unsigned HANDLERS = 5;       // the first ones, which have an SPSR
constexpr Word RESERVED = 0x00F00000;  // of CPSR and SPSR
constexpr Word STATUS = 0xF80F03DF & ~cpsr::MODE;
constexpr Word FPEXC_EN = 1u << 30;

// Registers that keep what is written, and of which bits.
struct Kept {
    Cp15 name;
    Word bits;
};
constexpr Kept KEPT[]{
    {sim::cp15::TTBR0, 0xFFFFC000}, {sim::cp15::TTBR1, 0xFFFFC000}, {sim::cp15::TTBCR, 7},
    {sim::cp15::DACR, ~0u},         {sim::cp15::DFSR, 0x1C0F},      {sim::cp15::IFSR, 0x140F},
    {sim::cp15::DFAR, ~0u},         {sim::cp15::IFAR, ~0u},         {sim::cp15::VBAR, 0xFFFFFFE0},
    {sim::cp15::CONTEXTIDR, ~0u},   {sim::cp15::TPIDRURW, ~0u},     {sim::cp15::TPIDRURO, ~0u},
    {sim::cp15::TPIDRPRW, ~0u},
};

struct Writer {
    Writer(Maker& maker_, bool thumb_, std::uint32_t at_, const char* name)
        : maker{maker_}, thumb{thumb_}, at{at_}, item{name, {}} {
        maker.take(7);  // the same register in all modes
    }
    ~Writer() { maker.give_back(); }

    Maker& maker;
    const bool thumb;
    const std::uint32_t at;
    Item item;

    void put(Word arm, Word in_thumb) { item.words.push_back(thumb ? in_thumb : arm); }
    void make(const char* arm, const char* in_thumb, bool (*allowed)(Word) = nullptr) {
        item.words.push_back(maker.word({"", thumb ? in_thumb : arm, allowed}));
    }
    // A coprocessor's, with any condition in ARM.
    void coprocessor(Word w) {
        put((maker.chance(60) ? 14 : maker.below(14)) << 28 | w, 0xE0000000 | w);
    }

    // To the register that is held.
    void constant(Word value) {
        for (Word top = 0; top < 2; ++top, value >>= 16) {
            const Word low = value & 0xFFF, high = value >> 12 & 0xF, t = maker.held();
            put(0xE3000000 | top << 22 | high << 16 | t << 12 | low,
                0xF2400000 | top << 23 | (low & 0x800) << 15 | high << 16 | (low & 0x700) << 4 |
                    t << 8 | (low & 0xFF));
        }
    }
    void store(unsigned number, int offset) {
        const Word base = maker.registers().low_base << 16, t = number << 12;
        const auto by = static_cast<Word>(offset < 0 ? -offset : offset);
        put(0xE5000000 | unsigned{offset >= 0} << 23 | base | t | by,
            (offset < 0 ? 0xF8400C00 : 0xF8C00000) | base | t | by);
    }
    void mode(Word to) { put(0xF1020000 | to, 0xF3AF8100 | to); }
    // One with an SPSR; in the user mode the MRS is undefined.
    void handlers_mode() {
        mode(MODES[maker.below(HANDLERS)]);
        make("1110000101001111dddd000000000000", "11110011111111111000dddd00000000");
    }
    Word any_status() {
        const Word mode = maker.chance(4) ? USR : MODES[maker.below(6)];
        return (any() & STATUS) | mode;
    }
    Word any() { return maker.below(0x10000) << 16 | maker.below(0x10000); }

    // ---- Returns: to the instruction after them ----

    // Where they return to may be of the other instruction set, and go on in the stream's.
    // In Thumb, they may go on in the midst of an IT block.
    bool other_set = false, in_it = false;
    Word saved_status() {
        other_set = maker.chance(30);
        in_it = thumb && !other_set && maker.chance(30);
        const Word it = in_it ? maker.below(28) << 11 | 0x400 : 0;  // two conditions
        return any_status() | it | (thumb != other_set ? cpsr::T : 0);
    }
    // To r14, the address so many bytes farther.
    void link(Word bytes) {
        Word offset = at + bytes + 6;
        for (const Word w : item.words) offset += w > 0xFFFF ? 4 : 2;
        if (thumb && other_set && offset % 4 != 0) item.words.push_back(0xBF00);
        if (thumb) item.words.push_back(0x46FE);  // MOV lr, pc
        put(0xE28FE000 | (bytes - 4), 0xF20E0E00 | (bytes + 2));
    }
    void land() {
        if (other_set) put(0xBF004778, 0xFFFFFAFF);  // BX pc, in Thumb; BLX to the next, in ARM
        for (Word i = 0; in_it && i < 2; ++i)        // ADD t, #n
            item.words.push_back(0x3010 | maker.held() << 8 | i);
    }
};

// ---- The items ----

void cps(Writer& w) {
    const Word masks = 1 + w.maker.below(7), imod = 2 + w.maker.below(2);
    const Word mode = MODES[w.maker.below(6)];
    switch (w.maker.below(3)) {
        case 0:
            w.put(0xF1000000 | imod << 18 | masks << 6, 0xB660 | (imod & 1) << 4 | masks);
            break;
        case 1: w.mode(mode); break;
        default:
            w.put(0xF1020000 | imod << 18 | masks << 6 | mode,
                  0xF3AF8100 | imod << 9 | masks << 5 | mode);
    }
}

// Of an MSR: in Thumb bits 11:8.
bool has_fields(Word w) { return (w >> 28 == 15 ? w & 0xF00 : w & 0xF0000) != 0; }

void write_cpsr(Writer& w) {
    const bool privileged = w.maker.chance(50);  // else without E
    if (privileged) w.handlers_mode();
    w.constant(w.any_status() | (w.any() & (cpsr::T | cpsr::J | cpsr::IT)));
    if (privileged)
        w.make("cccc00010010xxxx111100000000tttt", "111100111000tttt1000xxxx00000000", has_fields);
    else
        w.make("cccc00010010xx0x111100000000tttt", "111100111000tttt1000xx0x00000000", has_fields);
}

void write_spsr(Writer& w) {
    w.handlers_mode();
    w.constant(w.any() & ~RESERVED);
    w.make("cccc00010110xxxx111100000000tttt", "111100111001tttt1000xxxx00000000", has_fields);
    w.make("cccc000101001111dddd000000000000", "11110011111111111000dddd00000000");
}

// MOVS pc, lr and SUBS pc, lr, #n.
void return_by_link(Writer& w) {
    w.handlers_mode();
    w.constant(w.saved_status());
    w.put(0xE16FF000 | w.maker.held(), 0xF3908F00 | w.maker.held() << 16);
    const Word by = w.maker.chance(50) ? 0 : 4 * w.maker.below(61);
    const Word condition = w.other_set || w.maker.chance(60) ? 14 : w.maker.below(14);
    w.link(by + 4);
    w.put(condition << 28 | (by ? 0x025EF000 | by : 0x01B0F00E), 0xF3DE8F00 | by);
    w.land();
}

void rfe(Writer& w) {
    const bool up = w.maker.below(2), before = w.thumb ? !up : w.maker.below(2);
    const Word base = w.maker.registers().low_base << 16, back = w.maker.below(2) << 21;
    const int first = up ? before * 4 : before * -4 - 4;
    w.constant(w.saved_status());
    w.store(w.maker.held(), first + 4);
    w.link(8);
    w.store(14, first);
    w.put(0xF8100A00 | before << 24 | up << 23 | back | base,
          (up ? 0xE990C000 : 0xE810C000) | back | base);
    w.land();
}

// LDM with pc and ^; not in Thumb.
void return_by_ldm(Writer& w) {
    w.handlers_mode();
    w.constant(w.saved_status());
    w.put(0xE16FF000 | w.maker.held(), 0);
    const Word ldm = w.maker.word({"", "1110100xx1x1PPPP1lllllllllllllll"});
    int count = 0;
    for (unsigned i = 0; i < 16; ++i) count += ldm >> i & 1;
    const bool up = ldm >> 23 & 1, before = ldm >> 24 & 1;
    w.link(8);
    w.store(14, up ? 4 * (count - !before) : -4 * before);
    w.put(ldm, 0);
    w.land();
}

void srs(Writer& w) {
    const Word up = w.maker.below(2), before = w.maker.below(2);
    const Word rest = w.maker.below(2) << 21 | MODES[w.maker.below(6)];
    w.handlers_mode();
    w.put(0xF84D0500 | before << 24 | up << 23 | rest, (up ? 0xE98DC000 : 0xE80DC000) | rest);
}

// LDM and STM of the user mode's registers; not in Thumb.  Its r13 stays a stack.
void users_registers(Writer& w) {
    const auto has_list = [](Word word) { return (word & 0xFFFF) != 0; };
    w.handlers_mode();
    w.make("cccc100xx100PPPPxLxLLLLLLLLLLLLL", "", has_list);
    w.make("cccc100xx101PPPP0lllllllllllllll", "", has_list);
    w.store(13, 0);
    w.put(0xE8D06000 | w.maker.registers().low_base << 16, 0);  // LDM, {sp, lr}^
}

// Another is written after it, and a barrier of before ARMv7 done.
void kept_register(Writer& w) {
    const auto access = [&](const Kept& kept, Word opcode) {
        const Cp15& n = kept.name;
        return opcode | n.op1 << 21 | n.crn << 16 | w.maker.held() << 12 | n.op2 << 5 | n.crm;
    };
    const Kept& one = KEPT[w.maker.below(std::size(KEPT))];
    const Kept& other = KEPT[w.maker.below(std::size(KEPT))];
    w.constant(w.any() & one.bits);
    w.put(access(one, 0xEE000F10), access(one, 0xEE000F10));
    w.constant(w.any() & other.bits);
    w.coprocessor(access(other, 0x0E000F10));
    constexpr Word BARRIERS[]{0x0E070F95, 0x0E070F9A, 0x0E070FBA};
    w.coprocessor(BARRIERS[w.maker.below(3)]);
    w.coprocessor(access(one, 0x0E100F10) | (w.maker.chance(20) ? 0xF000 : 0));  // to the flags
}

// FPEXC and the registers that identify VFP.
void floating_point(Writer& w) {
    const Word which = w.maker.below(6), t = w.maker.held() << 12;
    if (which >= 3) {  // FPSID, MVFR1, MVFR0
        constexpr Word REGISTERS[]{0, 6, 7};
        w.coprocessor(0x0EF00A10 | REGISTERS[which - 3] << 16 | t);
        w.constant(0);
        return;
    }
    w.constant(w.maker.chance(60) ? FPEXC_EN : 0);
    w.put(w.maker.below(15) << 28 | 0x0EE80A10 | t, 0xEEE80A10 | t);
    w.put(0xEE300A81, 0xEE300A81);  // VADD.F32 s0, s1, s2
    w.coprocessor(0x0EF80A10 | t);
}

}  // namespace

Item system_begin(Maker& maker, bool thumb) {
    Writer w{maker, thumb, 0, "begin"};
    const Word base = maker.registers().low_base;
    w.constant(FPEXC_EN);
    w.put(0xEEE80A10 | maker.held() << 12, 0xEEE80A10 | maker.held() << 12);  // FPEXC
    Word stack = 0x80;
    for (const Word mode : MODES) {
        w.mode(mode);
        for (Word i = 8; mode == FIQ && i <= 12; ++i)
            w.put(0xE1A00000 | i << 12 | (i - 8), 0x4600 | (i & 8) << 4 | (i - 8) << 3 | (i & 7));
        w.constant(w.any() & ~RESERVED);
        w.put(0xE1A0E000 | maker.held(), 0x4686 | maker.held() << 3);  // MOV lr, t
        if (mode != SYS) w.put(0xE16FF00E, 0xF39E8F00);                // MSR SPSR, lr
        stack += 16;
        w.put(0xE280D000 | base << 16 | stack, 0xF2000D00 | base << 16 | stack);  // ADD sp, base
    }
    w.mode(maker.chance(15) ? USR : SVC);
    return w.item;
}

Item system_end(Maker& maker, bool thumb) {
    Writer w{maker, thumb, 0, "end"};
    int offset = 0;
    for (const Word mode : MODES) {
        w.mode(mode);
        for (const unsigned number : {8u, 9u, 10u, 11u, 12u, 13u, 14u})
            if (number > 12 || mode == FIQ || mode == SYS) w.store(number, offset += 4);
        if (mode == SYS) continue;
        w.put(0xE14F0000 | maker.held() << 12, 0xF3FF8000 | maker.held() << 8);
        w.store(maker.held(), offset += 4);
    }
    return w.item;
}

Item system_item(Maker& maker, bool thumb, std::uint32_t at) {
    static const struct {
        const char* name;
        void (*make)(Writer&);
        bool in_thumb;
    } items[]{
        {"CPS", cps, true},
        {"MSR CPSR", write_cpsr, true},
        {"MSR SPSR", write_spsr, true},
        {"MOVS pc", return_by_link, true},
        {"RFE", rfe, true},
        {"LDM pc ^", return_by_ldm, false},
        {"SRS", srs, true},
        {"LDM STM ^", users_registers, false},
        {"MCR MRC", kept_register, true},
        {"VMRS VMSR", floating_point, true},
    };
    unsigned which;
    do which = maker.below(std::size(items));
    while (thumb && !items[which].in_thumb);
    Writer w{maker, thumb, at, items[which].name};
    items[which].make(w);
    return w.item;
}

}  // namespace tb::core
