#include "sim/linux/alignment.h"

namespace sim {

namespace {

bool arm(std::uint32_t w) {
    const bool load = w >> 20 & 1;
    switch (w >> 25 & 7) {
        case 0:
            switch (w >> 4 & 0xF) {
                case 0xB: return true;   // LDRH, STRH
                case 0xD: return !load;  // LDRD
                case 0xF: return true;   // LDRSH, STRD
                default: return false;   // LDREX, SWP
            }
        case 2: return w >> 28 != 15;  // LDR, STR; not NEON's
        case 3:
        case 4: return true;
        default: return false;  // VFP
    }
}

// Only those that fault in Normal memory: it expects no others.
bool thumb32(std::uint32_t w) {
    const bool sp = (w >> 16 & 0xF) == 13;
    switch (w >> 16 & 0xFFE0) {
        case 0xE880:
        case 0xE8A0:
        case 0xE900:
        case 0xE920:  // LDM, STM
        case 0xE860:
        case 0xE960:
        case 0xE8E0:
        case 0xE9E0:
        case 0xE940:
        case 0xE9C0: return true;                          // LDRD, STRD
        case 0xF840: return sp && (w & 0x09FF) == 0x0904;  // PUSH and POP of one register
        default: return false;
    }
}

}  // namespace

bool kernel_does_unaligned(std::uint32_t word, bool thumb) {
    if (!thumb) return arm(word);
    return word <= 0xFFFF || thumb32(word);
}

}  // namespace sim
