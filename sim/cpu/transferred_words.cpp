#include "sim/cpu/transferred_words.h"

namespace sim {

namespace {

constexpr bool matches(std::uint32_t w, std::uint32_t mask, std::uint32_t value) {
    return (w & mask) == value;
}

unsigned listed(std::uint32_t list) {
    unsigned count = 0;
    for (; list != 0; list &= list - 1) ++count;
    return count;
}

// VLDM, VLDR and their like, which ARM and Thumb encode alike.
unsigned words_of_vfp(std::uint32_t w) {
    const bool doubles = w >> 8 & 1, one = matches(w, 0x01200000, 0x01000000);
    if (one) return doubles ? 2 : 1;
    return doubles ? w & 0xFE : w & 0xFF;
}

// VLD1 to VLD4 and VST1 to VST4, in ARM's encoding (A7.7).
unsigned words_of_structures(std::uint32_t w) {
    constexpr unsigned WORDS = 2;  // size
    const unsigned low = w >> 8 & 3;
    if (w >> 23 & 1) {  // one lane, or to all lanes
        const unsigned size = (w >> 10 & 3) == 3 ? w >> 6 & 3 : w >> 10 & 3;
        return size == WORDS ? low + 1 : 1;
    }
    const unsigned type = w >> 8 & 0xF;
    switch (type) {  // VLD1, whose registers follow each other in memory
        case 7: return 2;
        case 10: return 4;
        case 6: return 6;
        case 2: return 8;
        default: break;
    }
    if ((w >> 6 & 3) != WORDS) return 1;
    return type == 8 || type == 9 ? 4 : type == 4 || type == 5 ? 6 : 8;
}

unsigned words_of_arm(std::uint32_t w) {
    if (w >> 28 == 15) return w >> 24 == 0xF4 ? words_of_structures(w) : 1;
    if (matches(w, 0x0E000000, 0x08000000)) return listed(w & 0xFFFF);  // LDM, STM
    if (matches(w, 0x0E1000D0, 0x000000D0)) return 2;                   // LDRD, STRD
    if (matches(w, 0x0FE000F0, 0x01A00090)) return 2;                   // LDREXD, STREXD
    return matches(w, 0x0E000E00, 0x0C000A00) ? words_of_vfp(w) : 1;
}

unsigned words_of_thumb(std::uint32_t w) {
    if (w <= 0xFFFF) {
        if (w >> 12 == 0xC) return listed(w & 0xFF);                // LDM, STM
        return matches(w, 0xF600, 0xB400) ? listed(w & 0x1FF) : 1;  // PUSH, POP
    }
    if (matches(w, 0xFE400000, 0xE8000000)) {  // LDM, STM; RFE, SRS
        const bool several = (w >> 24 & 1) != (w >> 23 & 1);
        return several ? listed(w & 0xFFFF) : 1;
    }
    if (matches(w, 0xFE400000, 0xE8400000))  // LDRD, STRD; LDREXD, STREXD
        return w & 0x01200000 || matches(w, 0xFFE000F0, 0xE8C00070) ? 2 : 1;
    if (w >> 24 == 0xF9)
        return w >> 20 & 1 ? 1 : words_of_structures(0xF4000000 | (w & 0x00FFFFFF));
    return matches(w, 0xFE000E00, 0xEC000A00) ? words_of_vfp(w) : 1;
}

}  // namespace

unsigned transferred_words(std::uint32_t instruction, bool thumb) {
    const unsigned words = thumb ? words_of_thumb(instruction) : words_of_arm(instruction);
    return words == 0 ? 1 : words;
}

bool is_exclusive(std::uint32_t w, bool thumb) {
    if (!thumb) return w >> 28 != 15 && matches(w, 0x0F8000F0, 0x01800090);
    if (matches(w, 0xFFE00000, 0xE8400000)) return true;
    const std::uint32_t kind = w >> 4 & 0xF;  // of bytes, half-words, double words
    return matches(w, 0xFFE00000, 0xE8C00000) && (kind == 4 || kind == 5 || kind == 7);
}

}  // namespace sim
