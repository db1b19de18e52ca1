#include "tb/sim/arm_core/program.h"

namespace tb::core {

namespace {

bool has_list(std::uint32_t w) { return (w & 0xFFFF & ((w & 0xFFFF) - 1)) != 0; }
bool no_base(std::uint32_t w) { return has_list(w) && !bit(w, field(w, 19, 16)); }

// Without write-back: base registers never change.
const std::vector<Encoding> ARM_BUS{
    {"LDR", "cccc01011001qqqqdddd000xxxxxxx00"},
    {"STR", "cccc01011000qqqqnnnn000xxxxxxx00"},
    {"LDRB", "cccc01011101qqqqdddd000xxxxxxxxx"},
    {"STRB", "cccc01011100qqqqnnnn000xxxxxxxxx"},
    {"LDR register", "cccc01111001qqqqdddd00000000iiii"},
    {"LDRH", "cccc00011101qqqqddddxxxx1011xxx0"},
    {"LDRSB", "cccc00011101qqqqddddxxxx1101xxxx"},
    {"STRH", "cccc00011100qqqqnnnnxxxx1011xxx0"},
    {"LDRD", "cccc00011100qqqqrrrrxxxx1101xx00"},
    {"STRD", "cccc00011100qqqqooooxxxx1111xx00"},
    {"LDM", "cccc10001001qqqqllllllllllllllll", has_list},
    {"STM", "cccc10001000qqqqLLLLLLLLLLLLLLLL", has_list},
    {"VLDR", "cccc11011x01qqqqxxxx101x000xxxxx"},
    {"VSTR", "cccc11011x00qqqqxxxx101x000xxxxx"},
    {"VLDM", "cccc11001x01qqqq0xxx101100000110"},
    {"VSTM", "cccc11001x00qqqq0xxx101100000110"},
    {"VLD1", "111101000x10qqqq0xxx0111xx001111"},
    {"VST1", "111101000x00qqqq0xxx0111xx001111"},
};
const std::vector<Encoding> THUMB_BUS{
    {"LDR", "01101xxxxxqqqddd"},
    {"STR", "01100xxxxxqqqnnn"},
    {"LDRB", "01111xxxxxqqqddd"},
    {"STRH", "10000xxxxxqqqnnn"},
    {"LDRSH", "0101111iiiqqqddd"},
    {"LDR.W", "111110001101qqqqdddd000xxxxxxx00"},
    {"STR.W", "111110001100qqqqnnnn000xxxxxxx00"},
    {"LDRSB.W", "111110011001qqqqdddd000xxxxxxxxx"},
    {"LDRD", "1110100111x1qqqqddddeeee000xxxxx", [](std::uint32_t w) { return !bit(w, 21); }},
    {"STRD", "1110100111x0qqqqnnnnssss000xxxxx", [](std::uint32_t w) { return !bit(w, 21); }},
    {"LDM", "111010001001qqqqllllllllllllllll", has_list},
    {"STM", "111010001000qqqqLLLLLLLLLLLLLLLL", no_base},
};

enum class End { CONDITION, BRANCH, CALL, RETURN, LOAD, SVC, WFI, WFE };

struct Block {
    std::vector<std::uint32_t> words;
    std::vector<std::uint32_t> entries;  // offsets where others may branch to
    End end;
    unsigned target, entry, condition;
};

std::uint32_t arm_end(const Block& block, std::uint32_t at, std::uint32_t to) {
    const std::uint32_t offset = (to - (at + 8)) >> 2 & 0xFFFFFF;
    switch (block.end) {
        case End::CONDITION: return block.condition << 28 | 0x0A000000 | offset;
        case End::BRANCH: return 0xEA000000 | offset;
        case End::CALL: return 0xEB000000 | offset;
        case End::RETURN: return 0xE12FFF1E;
        case End::LOAD: return 0xE51FF004;  // of the word after it
        case End::SVC: return 0xEF000000;
        case End::WFI: return 0xE320F003;
        default: return 0xE320F002;
    }
}

// All of 32 bits.
std::uint32_t thumb_end(const Block& block, std::uint32_t at, std::uint32_t to) {
    const std::uint32_t offset = to - (at + 4), s = offset >> 31;
    const std::uint32_t low = offset >> 1 & 0x7FF;
    const std::uint32_t j1 = !((offset >> 23 & 1) ^ s), j2 = !((offset >> 22 & 1) ^ s);
    const std::uint32_t far =
        0xF0009000 | s << 26 | (offset >> 12 & 0x3FF) << 16 | j1 << 13 | j2 << 11 | low;
    switch (block.end) {
        case End::CONDITION:
            return 0xF0008000 | s << 26 | block.condition << 22 | (offset >> 12 & 0x3F) << 16 |
                   (offset >> 18 & 1) << 13 | (offset >> 19 & 1) << 11 | low;
        case End::BRANCH: return far;
        case End::CALL: return far | 1u << 14;
        case End::RETURN: return 0x4770BF00;  // BX lr, NOP
        case End::LOAD: return 0xF8DFF000;
        case End::SVC: return 0xDF00BF00;
        case End::WFI: return 0xF3AF8003;
        default: return 0xBF20BF00;
    }
}

// EOR rn, rn, #0x180000: from the bus to RAM, or back.
std::uint32_t elsewhere(unsigned n, bool thumb) {
    return thumb ? 0xF48010C0 | n << 16 | n << 8 : 0xE2200818 | n << 16 | n << 12;
}

unsigned size(std::uint32_t word, bool thumb) { return thumb && word <= 0xFFFF ? 2 : 4; }

}  // namespace

Program make_program(Random& random, const ProgramKind& kind, std::uint32_t address) {
    const bool thumb = kind.thumb;
    Maker maker{random, thumb};
    maker.keep(14);
    const auto one = [&] {
        const auto& bus = thumb ? THUMB_BUS : ARM_BUS;
        const auto& computing = thumb ? thumb_encodings() : arm_encodings();
        const auto& rows = kind.bus && maker.chance(25) ? bus : computing;
        return maker.word(rows[maker.below(static_cast<unsigned>(rows.size()))]);
    };

    std::vector<Block> blocks(4 + maker.below(12));
    for (Block& block : blocks) {
        block.entries.push_back(0);
        for (unsigned left = maker.below(12); left > 0; --left) {
            if (kind.bus && maker.chance(5)) {
                block.words.push_back(elsewhere(maker.registers().low_any, thumb));
            } else if (thumb && kind.it_blocks && maker.chance(20)) {
                const std::uint32_t cond = maker.below(14);
                const bool two = maker.chance(50);
                block.words.push_back(0xBF00 | cond << 4 | (two ? 4 | maker.below(2) << 3 : 8));
                for (unsigned i = 0; i < (two ? 2 : 1);) {
                    const std::uint32_t word = one();
                    if (word <= 0xFFFF && word < 0x0800 && !(word >> 6)) continue;  // MOVS
                    block.words.push_back(word);
                    ++i;
                }
            } else {
                block.words.push_back(one());
            }
            std::uint32_t offset = 0;
            for (const std::uint32_t word : block.words) offset += size(word, thumb);
            block.entries.push_back(offset);
        }
        const unsigned percent = maker.below(100);
        block.end = percent < 40   ? End::CONDITION
                    : percent < 50 ? End::BRANCH
                    : percent < 70 ? End::CALL
                    : percent < 80 ? End::RETURN
                    : percent < 90 ? End::LOAD
                    : !kind.stops  ? End::CONDITION
                    : percent < 94 ? End::SVC
                    : percent < 97 ? End::WFI
                                   : End::WFE;
        block.target = maker.below(static_cast<unsigned>(blocks.size()));
        block.entry = maker.chance(50) ? 0 : maker.below(100);
        block.condition = maker.below(14);
    }
    blocks.back().end = End::BRANCH;

    Program program{thumb, maker.registers(), {}, {}};
    std::uint32_t at = address;
    for (Block& block : blocks) {
        program.blocks.push_back(at);
        for (const std::uint32_t word : block.words) at += size(word, thumb);
        if (thumb && block.end == End::LOAD && at % 4 != 0) {
            block.words.push_back(0xBF00);
            at += 2;
        }
        at += block.end == End::LOAD ? 8 : 4;
    }
    const auto half = [&](std::uint32_t value) {
        program.code.push_back(static_cast<std::uint16_t>(value));
    };
    const auto put = [&](std::uint32_t word) {
        if (!thumb) half(word);
        if (size(word, thumb) == 4) half(word >> 16);
        if (thumb) half(word);
    };
    for (const Block& block : blocks) {
        for (const std::uint32_t word : block.words) put(word);
        const auto place = address + 2 * static_cast<std::uint32_t>(program.code.size());
        const auto& entries = blocks[block.target].entries;
        const std::uint32_t target =
            program.blocks[block.target] + entries[block.entry % entries.size()];
        put(thumb ? thumb_end(block, place, target) : arm_end(block, place, target));
        if (block.end != End::LOAD) continue;
        half(target | thumb);
        half(target >> 16);
    }
    return program;
}

}  // namespace tb::core
