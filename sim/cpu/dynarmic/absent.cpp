// absent.cpp - instructions that dynarmic has and the Cortex-A9 has not, and words that would be
// instructions only with another condition.
#include <cstddef>

#include "sim/cpu/dynarmic/instructions.h"
#include "sim/cpu/dynarmic/missed_neon.h"

namespace sim {

namespace {

struct Encoding {
    std::uint32_t mask, value;
};

template <std::size_t N>
bool is_one_of(const Encoding (&encodings)[N], std::uint32_t word) {
    for (const Encoding& encoding : encodings)
        if (is(word, encoding.mask, encoding.value)) return true;
    return false;
}

// Of NEON's data processing, as ARM encodings (ARM DDI 0406C, A7.4).  Undefined on the Cortex-A9,
// except for those of is_missed_neon().
constexpr Encoding NEON[] = {
    // Three registers of the same length
    {0xFE800F10, 0xF2000510},                            // VQRSHL
    {0xFF800F10, 0xF3000B10}, {0xFE800F00, 0xF2000C00},  // VFMA, VFMS, SHA
    {0xFFA00F10, 0xF3200D10}, {0xFFA00F10, 0xF2200E00},
    {0xFF800F10, 0xF2000E10}, {0xFF800F10, 0xF3000F10},  // VMAXNM, VMINNM
};
// Without L and a size it is a constant instead.
constexpr Encoding NEON_SHIFTS[] = {
    {0xFF800F10, 0xF2800410}, {0xFE800E90, 0xF2800890}, {0xFE800F90, 0xF2800A90},
    {0xFE800FD0, 0xF2800A50}, {0xFE800F10, 0xF2800B10}, {0xFE800E10, 0xF2800C10},
    {0xFE800E90, 0xF2800E90},
};
// Of these, size 3 is another group.
constexpr Encoding NEON_SIZED[] = {
    // Different lengths
    {0xFE800D50, 0xF2800400},  // VADDHN, VSUBHN
    {0xFE800D50, 0xF2800900},  // VQDMLAL, VQDMLSL
    {0xFE800F50, 0xF2800D00},  // VQDMULL
    {0xFE900F50, 0xF2900E00},
    {0xFEA00F50, 0xF2A00E00},  // VMULL of longer polynomials
    {0xFE800F50, 0xF2800F00},
    // A scalar
    {0xFE800B50, 0xF2800340},  // VQDMLAL, VQDMLSL
    {0xFF800F50, 0xF3800B40},
    {0xFE800E50, 0xF2800E40},
};
constexpr Encoding NEON_TWO[] = {
    {0xFFB30F10, 0xF3B00300},  // AES
    {0xFFB30FD0, 0xF3B20340},
    {0xFFB30F90, 0xF3B20380},  // SHA
    {0xFFBF0E10, 0xF3B70400},  // VRECPE, VRSQRTE of half precision
};

bool is_absent_neon(std::uint32_t w) {
    if (is_missed_neon(w, false)) return false;
    return is_one_of(NEON, w) || is_one_of(NEON_TWO, w) ||
           ((w & 0x00380080) != 0 && is_one_of(NEON_SHIFTS, w)) ||
           ((w >> 20 & 3) != 3 && is_one_of(NEON_SIZED, w));
}

constexpr Encoding UNCONDITIONAL[] = {
    {0xFFF1FE20, 0xF1000000},                            // CPS
    {0xFFFFFDFF, 0xF1010000},                            // SETEND
    {0xFF100000, 0xF4000000},                            // NEON's loads and stores
    {0xFF30F000, 0xF510F000},                            // PLD, PLDW
    {0xFF30F010, 0xF710F000}, {0xFF30F000, 0xF410F000},  // PLI
    {0xFF30F010, 0xF610F000}, {0xFFFFFFFF, 0xF57FF01F},  // CLREX
    {0xFFFFFFF0, 0xF57FF040}, {0xFFFFFFF0, 0xF57FF050},  // DSB, DMB
    {0xFFFFFFF0, 0xF57FF060},                            // ISB
    {0xFE50FFFF, 0xF8100A00}, {0xFE5FFFE0, 0xF84D0500},  // RFE, SRS
    {0xFE000000, 0xFA000000},                            // BLX
};

// All of VFPv3 (A7.5 - A7.9).  Another word in its space would be one for a coprocessor.
constexpr Encoding VFP[] = {
    {0x0F800E10, 0x0E000A00},                            // VMLA .. VSUB
    {0x0FB00E50, 0x0E800A00},                            // VDIV
    {0x0FB00EF0, 0x0EB00A00}, {0x0FBE0E50, 0x0EB00A40},  // VMOV, VABS, VNEG, VSQRT
    {0x0FBE0F50, 0x0EB20A40},                            // VCVTB, VCVTT
    {0x0FBF0E50, 0x0EB40A40}, {0x0FBF0E7F, 0x0EB50A40},  // VCMP
    {0x0FBF0ED0, 0x0EB70AC0}, {0x0FBF0E50, 0x0EB80A40},  // VCVT
    {0x0FBA0E50, 0x0EBA0A40}, {0x0FBE0E50, 0x0EBC0A40},
    {0x0FE00F7F, 0x0E000A10}, {0x0FE00ED0, 0x0C400A10},  // VMOV of words
    {0x0FC00F7F, 0x0E000B10}, {0x0FC00F3F, 0x0E000B30},  // VMOV of lanes
    {0x0FC00F1F, 0x0E400B10}, {0x0F500F3F, 0x0E100B30},
    {0x0F500F1F, 0x0E500B10}, {0x0F900F5F, 0x0E800B10},  // VDUP
    {0x0FE00FFF, 0x0EE00A10},                            // VMRS, VMSR
    {0x0F200E00, 0x0D000A00}, {0x0F800E00, 0x0C800A00},  // VLDR, VLDM, VSTR, VSTM
    {0x0FA00E00, 0x0D200A00},
};

bool is_absent_vfp(std::uint32_t w) {
    const bool vfp = is(w, 0x0C000E00, 0x0C000A00) && !is(w, 0x0F000000, 0x0F000000);
    return vfp && !is_one_of(VFP, w);
}

constexpr Encoding ARM[] = {
    {0x0F900EF0, 0x01800C90},  // LDA, STL
    {0x0F900FF0, 0x01800E90},  // LDAEX, STLEX
    {0x0F900DF0, 0x01000040},  // CRC32
};

}  // namespace

bool is_absent(std::uint32_t w, bool thumb) {
    if (thumb) {
        if (w >> 16 == 0) return false;
        if (is(w, 0xEF000000, 0xEF000000))
            return is_absent_neon(0xF2000000 | (w >> 4 & 0x01000000) | (w & 0x00FFFFFF));
        if (is(w, 0xFC000000, 0xFC000000)) return true;
        if (is(w, 0xFFE00F8F, 0xE8C00F8F)) return true;  // LDA, STL
        return w >> 28 == 0xE && is_absent_vfp(w);
    }
    if (w >> 28 != 0xF) return is_absent_vfp(w) || is_one_of(ARM, w);
    if (is(w, 0xFE000000, 0xF2000000)) return is_absent_neon(w);
    return !is_one_of(UNCONDITIONAL, w);
}

}  // namespace sim
