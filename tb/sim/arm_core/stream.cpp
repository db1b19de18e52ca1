#include "tb/sim/arm_core/stream.h"

#include <algorithm>
#include <cstring>
#include <stdexcept>

#include "tb/sim/arm_core/differences.h"
#include "tb/sim/arm_core/maker.h"
#include "tb/sim/arm_core/system_items.h"

namespace tb::core {

namespace {

// ---- Items of several instructions ----

bool thumb_other_word(std::uint32_t w) { return field(w, 15, 12) != field(w, 11, 8); }
bool thumb_other(std::uint32_t w) { return field(w, 15, 12) != field(w, 3, 0); }
bool thumb_other_pair(std::uint32_t w) {
    return thumb_other(w) && field(w, 11, 8) != field(w, 3, 0);
}
bool arm_other(std::uint32_t w) { return field(w, 15, 12) != field(w, 3, 0); }
bool arm_other_pair(std::uint32_t w) {
    return field(w, 15, 12) != field(w, 3, 0) && field(w, 15, 12) != field(w, 3, 0) + 1;
}

bool has_register(std::uint32_t w) { return (w & 0xFFFF) != 0; }

constexpr std::uint32_t ARM_CLREX = 0xF57FF01F, THUMB_CLREX = 0xF3BF8F2F;
const Encoding ARM_ALIGN{"BIC", "111000111100PPPPtttt000000000111"};
const Encoding THUMB_ALIGN{"BIC", "111100000010PPPP0000tttt00000111"};
const Encoding ARM_LOADS[]{{"LDREX", "cccc00011001ttttdddd111110011111"},
                           {"LDREXB", "cccc00011101ttttdddd111110011111"},
                           {"LDREXH", "cccc00011111ttttdddd111110011111"},
                           {"LDREXD", "cccc00011011ttttrrrr111110011111"}};
const Encoding ARM_STORES[]{{"STREX", "cccc00011000ttttdddd11111001nnnn", arm_other},
                            {"STREXB", "cccc00011100ttttdddd11111001nnnn", arm_other},
                            {"STREXH", "cccc00011110ttttdddd11111001nnnn", arm_other},
                            {"STREXD", "cccc00011010ttttdddd11111001oooo", arm_other_pair}};
const Encoding THUMB_LOADS[]{{"LDREX", "111010000101ttttdddd111100000010"},
                             {"LDREXB", "111010001101ttttdddd111101001111"},
                             {"LDREXH", "111010001101ttttdddd111101011111"},
                             {"LDREXD", "111010001101ttttddddeeee01111111"}};
const Encoding THUMB_STORES[]{{"STREX", "111010000100ttttnnnndddd00000010", thumb_other_word},
                              {"STREXB", "111010001100ttttnnnn11110100dddd", thumb_other},
                              {"STREXH", "111010001100ttttnnnn11110101dddd", thumb_other},
                              {"STREXD", "111010001100ttttnnnnssss0111dddd", thumb_other_pair}};

Item exclusive(Maker& maker, bool thumb, const Encoding& between) {
    maker.take();
    // A store that follows a load of another size may do both.
    Item item{"exclusive", {thumb ? THUMB_CLREX : ARM_CLREX}};
    item.words.push_back(maker.word(thumb ? THUMB_ALIGN : ARM_ALIGN));
    const unsigned kind = maker.below(4);
    item.words.push_back(maker.word((thumb ? THUMB_LOADS : ARM_LOADS)[kind]));
    if (maker.chance(30)) {
        item.words.push_back(maker.word(between));
        item.name += std::string{" around "} + between.name;
    }
    item.words.push_back(maker.word((thumb ? THUMB_STORES : ARM_STORES)[kind]));
    maker.give_back();
    return item;
}

const Encoding ARM_PLACE{"ADD", "111000101000PPPPtttt0000000xxx00"};
const Encoding THUMB_PLACE{"ADDW", "111100100000PPPP0000tttt000xxx00"};
const Encoding ARM_LDM{"LDM", "cccc100xx001ttttllllllllllllllll"};
const Encoding THUMB_LDMS[]{{"LDM of 16 bits", "11001tttllllllll"},
                            {"LDM", "111010001001ttttllllllllllllllll", has_register},
                            {"LDMDB", "111010010001ttttllllllllllllllll", has_register}};

// LDM with its base in the list, and without write-back.
Item load_with_base(Maker& maker, bool thumb) {
    maker.take(7);
    Item item{"LDM of its base", {maker.word(thumb ? THUMB_PLACE : ARM_PLACE)}};
    const std::uint32_t ldm = maker.word(thumb ? THUMB_LDMS[maker.below(3)] : ARM_LDM);
    item.words.push_back(ldm | 1u << maker.held());
    maker.give_back();
    return item;
}

// FPSCR with a value that it may have, without vectors and traps.
Item set_fpscr(Maker& maker, bool thumb) {
    maker.take();
    const Encoding arm[]{{"MOVW", "111000110000xxxxtttt0000x00xxxxx"},
                         {"MOVT", "111000110100xxxxttttxxxxxx000000"},
                         {"VMSR", "1110111011100001tttt101000010000"}};
    const Encoding in_thumb[]{{"MOVW", "11110x10010000000000ttttx00xxxxx"},
                              {"MOVT", "111100101100xxxx0xxxttttxx000000"},
                              {"VMSR", "1110111011100001tttt101000010000"}};
    Item item{"VMSR", {}};
    for (unsigned i = 0; i < 3; ++i) item.words.push_back(maker.word((thumb ? in_thumb : arm)[i]));
    maker.give_back();
    return item;
}

// FPSCR without its cumulative flags, which the processor does not keep exactly.
Item get_fpscr(Maker& maker, bool thumb) {
    maker.take();
    Item item{"VMRS", {maker.word({"VMRS", "1110111011110001tttt101000010000"})}};
    item.words.push_back(maker.word(
        {"BIC", thumb ? "111100000010tttt0000tttt10011111" : "111000111100tttttttt000010011111"}));
    maker.give_back();
    return item;
}

}  // namespace

unsigned Stream::instructions() const {
    std::size_t count = 0;
    for (const Item& item : items) count += item.words.size();
    return static_cast<unsigned>(count);
}

std::vector<std::uint16_t> Stream::code(std::size_t count) const {
    std::vector<std::uint16_t> halves;
    for (std::size_t i = 0; i < count; ++i)
        for (const std::uint32_t word : items[i].words) {
            if (!thumb) halves.push_back(static_cast<std::uint16_t>(word));
            if (!thumb || word > 0xFFFF) halves.push_back(static_cast<std::uint16_t>(word >> 16));
            if (thumb) halves.push_back(static_cast<std::uint16_t>(word));
        }
    if (thumb) {
        halves.push_back(0xDE00);
    } else {
        halves.push_back(0x00F0);
        halves.push_back(0xE7F0);
    }
    return halves;
}

Stream make_stream(Random& random, bool thumb, Kind kind, unsigned length, bool aborts) {
    Stream stream{thumb, {}, {}};
    Maker maker{random, thumb};
    stream.registers = maker.registers();
    using Table = const std::vector<Encoding>& (*)();
    const Table computing = thumb ? thumb_encodings : arm_encodings;
    const Table memory = thumb ? thumb_memory_encodings : arm_memory_encodings;

    // Whether a row is one of VFP or NEON, which have ARM's encodings.
    struct Pick {
        const Encoding* row;
        bool shared;
    };
    const auto pick = [&]() -> Pick {
        for (;;) {
            unsigned which = maker.below(5);
            if (kind == Kind::COMPUTING) which = 0;
            if (kind == Kind::MEMORY) which = maker.chance(60) ? 1 : 0;
            if (kind == Kind::VFP || kind == Kind::NEAREST) which = maker.chance(85) ? 2 : 0;
            if (kind == Kind::NEON_COMPUTING) which = maker.chance(85) ? 3 : 0;
            if (kind == Kind::SYSTEM) which = maker.chance(70) ? 0 : 2 + maker.below(2);
            if (kind == Kind::NEON) which = maker.chance(80) ? 3 : maker.chance(80) ? 4 : 0;
            const Table tables[]{computing, memory, vfp_encodings, neon_encodings,
                                 neon_memory_encodings};
            const auto& table = tables[which]();
            const Encoding& row = table[maker.below(static_cast<unsigned>(table.size()))];
            if (is_compared(row, kind == Kind::NEAREST)) return {&row, which >= 2};
        }
    };
    const auto one = [&](const Pick& picked) {
        std::uint32_t word;
        do word = maker.word(*picked.row);
        while (asks_for_more(word, aborts ? 16 : 0));
        return thumb && picked.shared ? to_thumb(word) : word;
    };

    stream.items.push_back({"CLREX", {thumb ? THUMB_CLREX : ARM_CLREX}});
    if (kind == Kind::SYSTEM) stream.items.push_back(system_begin(maker, thumb));
    if (kind == Kind::SYSTEM) length += stream.instructions();
    while (stream.instructions() < length) {
        if ((kind == Kind::MEMORY || kind == Kind::MIXED) && maker.chance(4)) {
            const auto& table = computing();
            stream.items.push_back(
                exclusive(maker, thumb, table[maker.below(static_cast<unsigned>(table.size()))]));
        } else if ((kind == Kind::MEMORY || kind == Kind::MIXED) && maker.chance(3)) {
            stream.items.push_back(load_with_base(maker, thumb));
        } else if (kind == Kind::SYSTEM && maker.chance(40)) {
            const auto bytes = 2 * stream.code(stream.items.size()).size() - (thumb ? 2 : 4);
            stream.items.push_back(system_item(maker, thumb, static_cast<std::uint32_t>(bytes)));
        } else if (kind != Kind::COMPUTING && maker.chance(2)) {
            const std::uint32_t big = maker.below(2);
            stream.items.push_back({"SETEND", {thumb ? 0xB650 | big << 3 : 0xF1010000 | big << 9}});
        } else if ((kind == Kind::VFP || kind == Kind::NEON || kind == Kind::NEON_COMPUTING ||
                    kind == Kind::MIXED) &&
                   maker.chance(2)) {
            stream.items.push_back((maker.chance(50) ? set_fpscr : get_fpscr)(maker, thumb));
        } else if (thumb && maker.chance(15)) {
            const unsigned count = 1 + maker.below(4);
            const unsigned cond = maker.below(15), low = cond & 1;
            unsigned mask = 0;
            for (unsigned i = 1; i < count; ++i)
                mask = mask << 1 | (cond == 14 ? low : maker.below(2));
            mask = (mask << 1 | 1) << (4 - count);
            Item item{"IT", {0xBF00 | cond << 4 | mask}};
            while (item.words.size() <= count) {
                const Pick picked = pick();
                if (!is_compared_in_it(*picked.row)) continue;
                item.words.push_back(one(picked));
                item.name += std::string{" "} + picked.row->name;
            }
            stream.items.push_back(item);
        } else {
            const Pick picked = pick();
            stream.items.push_back({picked.row->name, {one(picked)}});
        }
    }
    if (kind == Kind::SYSTEM) stream.items.push_back(system_end(maker, thumb));
    return stream;
}

}  // namespace tb::core
