// Random loads and stores of NEON's structures, in ARM's encodings.
#include "tb/sim/arm_core/encodings.h"

namespace tb::core {

namespace {

using Word = std::uint32_t;

unsigned first(Word w) { return field(w, 15, 12) | bit(w, 22) << 4; }

// VLD1 - VLD4 of whole registers: how many and how far apart by type (A7.7.1).
bool multiple(Word w) {
    const Word type = field(w, 11, 8), size = field(w, 7, 6), align = field(w, 5, 4);
    switch (type) {
        case 7: return align < 2;                                      // VLD1, 1
        case 10: return align != 3 && first(w) + 2 <= 32;              // VLD1, 2
        case 6: return align < 2 && first(w) + 3 <= 32;                // VLD1, 3
        case 2: return first(w) + 4 <= 32;                             // VLD1, 4
        case 8: return size != 3 && align != 3 && first(w) + 2 <= 32;  // VLD2
        case 9: return size != 3 && align != 3 && first(w) + 3 <= 32;
        case 3: return size != 3 && first(w) + 4 <= 32;
        case 4: return size != 3 && align < 2 && first(w) + 3 <= 32;  // VLD3
        case 5: return size != 3 && align < 2 && first(w) + 5 <= 32;
        case 0: return size != 3 && first(w) + 4 <= 32;  // VLD4
        case 1: return size != 3 && first(w) + 7 <= 32;
        default: return false;
    }
}

// One lane: index_align by size and number of registers (A8.8.321 and following).
bool one(Word w) {
    const Word n = field(w, 9, 8), size = field(w, 11, 10), a = field(w, 7, 4);
    if (size == 3) return false;
    const bool far = size == 1 ? bit(a, 1) : size == 2 && bit(a, 2);
    if (first(w) + (far ? 2 * n : n) >= 32) return false;
    switch (n) {
        case 0:
            return size == 0   ? !bit(a, 0)
                   : size == 1 ? !bit(a, 1)
                               : !bit(a, 2) && ((a & 3) == 0 || (a & 3) == 3);
        case 1: return size != 2 || !bit(a, 1);
        case 2: return size == 2 ? (a & 3) == 0 : !bit(a, 0);
        default: return size != 2 || (a & 3) != 3;
    }
}

// One element to all lanes.
bool all(Word w) {
    const Word n = field(w, 9, 8), size = field(w, 7, 6), twice = bit(w, 5), align = bit(w, 4);
    if (n == 0 && first(w) + twice >= 32) return false;
    if (n != 0 && first(w) + n * (1 + twice) >= 32) return false;
    switch (n) {
        case 0: return size != 3 && !(size == 0 && align);
        case 1: return size != 3;
        case 2: return size != 3 && !align;
        default: return size != 3 || align;
    }
}

}  // namespace

const std::vector<Encoding>& neon_memory_encodings() {
    static const std::vector<Encoding> table{
        {"VLD1-4", "111101000x10qqqqxxxxxxxxxxxx1111", multiple},
        {"VLD1-4 !", "111101000x10qqqqxxxxxxxxxxxx1101", multiple},
        {"VLD1-4 register", "111101000x10qqqqxxxxxxxxxxxxiiii", multiple},
        {"VST1-4", "111101000x00qqqqxxxxxxxxxxxx1111", multiple},
        {"VST1-4 !", "111101000x00qqqqxxxxxxxxxxxx1101", multiple},
        {"VST1-4 register", "111101000x00qqqqxxxxxxxxxxxxiiii", multiple},
        {"VLD1-4 lane", "111101001x10qqqqxxxxxxxxxxxx1111", one},
        {"VLD1-4 lane !", "111101001x10qqqqxxxxxxxxxxxx1101", one},
        {"VLD1-4 lane register", "111101001x10qqqqxxxxxxxxxxxxiiii", one},
        {"VST1-4 lane", "111101001x00qqqqxxxxxxxxxxxx1111", one},
        {"VST1-4 lane !", "111101001x00qqqqxxxxxxxxxxxx1101", one},
        {"VST1-4 lane register", "111101001x00qqqqxxxxxxxxxxxxiiii", one},
        {"VLD1-4 all lanes", "111101001x10qqqqxxxx11xxxxxx1111", all},
        {"VLD1-4 all lanes !", "111101001x10qqqqxxxx11xxxxxx1101", all},
        {"VLD1-4 all lanes register", "111101001x10qqqqxxxx11xxxxxxiiii", all},
    };
    return table;
}

}  // namespace tb::core
