#include "sim/cpu/dynarmic/alignment.h"

#include <algorithm>

#include "sim/cpu/dynarmic/instructions.h"

namespace sim {

namespace {

constexpr Alignment ANY{}, HALF{2, false, false}, WORD{4, false, false},
    WORD_ALWAYS{4, true, false};

Alignment of_size(unsigned log2) { return {1u << log2, false, false}; }
Alignment exclusive(unsigned log2) { return {1u << log2, true, false}; }

// `asked`: what :<align> asks for, 0 if it is not written; `element`: what there is without it.
Alignment structure(std::uint32_t asked, std::uint32_t element) {
    if (asked == 0) return {element, false, false};
    return {asked, true, asked > element};
}

// VLD1 - VLD4 and VST1 - VST4, in ARM's encoding (A7.7).
Alignment structures(std::uint32_t w) {
    const unsigned registers = w >> 8 & 3, low = w >> 4 & 0xF;
    if (!(w >> 23 & 1)) {
        const unsigned align = low & 3;
        return structure(align ? 4u << align : 0, 1u << (w >> 6 & 3));
    }
    unsigned size = w >> 10 & 3;
    if (size == 3) {  // to all lanes
        size = w >> 6 & 3;
        if (registers == 3) {
            const std::uint32_t element = size == 3 ? 4 : 1u << size;
            return structure(low & 1 ? (size == 3 ? 16 : size == 2 ? 8 : 4 * element) : 0, element);
        }
        return structure(low & 1 && registers != 2 ? (registers + 1) << size : 0, 1u << size);
    }
    const std::uint32_t element = 1u << size;
    switch (registers) {
        case 0: return structure(size > 0 && (low & 1) ? element : 0, element);
        case 1: return structure(low & 1 ? 2 * element : 0, element);
        case 2: return structure(0, element);
        default:
            if (size == 2) return structure(low & 3 ? 4u << (low & 3) : 0, element);
            return structure(low & 1 ? 4 * element : 0, element);
    }
}

Alignment of_arm(std::uint32_t w) {
    if (w >> 28 == 15) return is(w, 0xFF100000, 0xF4000000) ? structures(w) : WORD_ALWAYS;
    switch (w >> 25 & 7) {
        case 0: {
            if (!is(w, 0x90, 0x90)) return ANY;  // data processing
            const unsigned kind = w >> 5 & 3;
            const bool load = w >> 20 & 1;
            if (kind == 0) {
                if (!(w >> 23 & 1)) return w >> 22 & 1 ? ANY : WORD_ALWAYS;  // SWPB, SWP
                constexpr unsigned LOG2[] = {2, 3, 0, 1};
                return exclusive(LOG2[w >> 21 & 3]);
            }
            if (kind == 1) return HALF;
            if (!load) return WORD_ALWAYS;  // LDRD, STRD
            return kind == 2 ? ANY : HALF;
        }
        case 2:
        case 3: return w >> 22 & 1 ? ANY : WORD;
        default: return WORD_ALWAYS;  // LDM, STM, VLDM, VLDR and their like
    }
}

Alignment of_thumb16(std::uint32_t w) {
    switch (w >> 12) {
        case 5: {
            constexpr unsigned LOG2[] = {2, 1, 0, 0, 2, 1, 0, 1};
            return of_size(LOG2[w >> 9 & 7]);
        }
        case 7: return ANY;
        case 8: return HALF;
        case 4:
        case 6:
        case 9: return WORD;
        default: return WORD_ALWAYS;
    }
}

Alignment of_thumb32(std::uint32_t w) {
    if (is(w, 0xFF100000, 0xF9000000)) return structures(0xF4000000 | (w & 0x00FFFFFF));
    if (is(w, 0xFE000000, 0xF8000000)) return of_size(w >> 21 & 3);
    if (!is(w, 0xFF600000, 0xE8400000)) return WORD_ALWAYS;  // multiples, pairs, coprocessors
    if (!(w >> 23 & 1)) return exclusive(2);                 // LDREX, STREX
    const unsigned kind = w >> 4 & 0xF;
    if (kind < 2) return kind == 0 ? ANY : HALF;  // TBB, TBH
    return exclusive(kind & 3);
}

}  // namespace

std::uint32_t as_doublewords(std::uint32_t w, bool thumb) {
    if (!is(w, 0xFF900030, thumb ? 0xF9000010 : 0xF4000010)) return w;
    const unsigned type = w >> 8 & 0xF;
    const bool consecutive = type == 2 || type == 6 || type == 7 || type == 10;
    return consecutive ? w | 0xC0 : w;
}

Alignment alignment(std::uint32_t word, bool thumb) {
    if (!thumb) return of_arm(word);
    return word <= 0xFFFF ? of_thumb16(word) : of_thumb32(word);
}

}  // namespace sim
