// Random VFP instructions (VFPv3-D32 with half-precision conversions, without fused multiplies).
#include "tb/sim/arm_core/encodings.h"

namespace tb::core {

namespace {

using Word = std::uint32_t;

// VCVT between fixed and floating point: no more fraction bits than bits.
bool is_fixed(Word w) { return (field(w, 3, 0) << 1 | bit(w, 5)) <= (bit(w, 7) ? 32u : 16u); }
bool is_pair(Word w) { return (field(w, 3, 0) << 1 | bit(w, 5)) < 31; }
bool is_lane(Word w) { return bit(w, 22) || bit(w, 5) || !bit(w, 6); }
bool is_loaded_lane(Word w) { return is_lane(w) && !(bit(w, 23) && !bit(w, 22) && !bit(w, 5)); }
bool is_all_lanes(Word w) { return !(bit(w, 22) && bit(w, 5)) && !(bit(w, 21) && bit(w, 16)); }

bool is_multiple(Word w) {
    const Word mode = bit(w, 24) << 2 | bit(w, 23) << 1 | bit(w, 21);
    const Word words = field(w, 7, 0), d = field(w, 15, 12);
    if ((mode != 2 && mode != 3 && mode != 5) || words == 0) return false;
    if (!bit(w, 8)) return (d << 1 | bit(w, 22)) + words <= 32;
    return words % 2 == 0 && words <= 32 && (bit(w, 22) << 4 | d) + words / 2 <= 32;
}

}  // namespace

const std::vector<Encoding>& vfp_encodings() {
    static const std::vector<Encoding> table{
        {"VMLA VMLS", "cccc11100x00xxxxxxxx101xxxx0xxxx"},
        {"VNMLA VNMLS", "cccc11100x01xxxxxxxx101xxxx0xxxx"},
        {"VMUL VNMUL", "cccc11100x10xxxxxxxx101xxxx0xxxx"},
        {"VADD VSUB", "cccc11100x11xxxxxxxx101xxxx0xxxx"},
        {"VDIV", "cccc11101x00xxxxxxxx101xx0x0xxxx"},
        {"VMOV immediate", "cccc11101x11xxxxxxxx101x0000xxxx"},
        {"VMOV VABS", "cccc11101x110000xxxx101xx1x0xxxx"},
        {"VNEG VSQRT", "cccc11101x110001xxxx101xx1x0xxxx"},
        {"VCVTB VCVTT", "cccc11101x11001xxxxx1010x1x0xxxx"},
        {"VCMP", "cccc11101x110100xxxx101xx1x0xxxx"},
        {"VCMP zero", "cccc11101x110101xxxx101xx1000000"},
        {"VCVT single double", "cccc11101x110111xxxx101x11x0xxxx"},
        {"VCVT from integer", "cccc11101x111000xxxx101xx1x0xxxx"},
        {"VCVT from fixed", "cccc11101x11101xxxxx101xx1x0xxxx", is_fixed},
        {"VCVT to fixed", "cccc11101x11111xxxxx101xx1x0xxxx", is_fixed},
        {"VCVT to integer", "cccc11101x11110xxxxx101xx1x0xxxx"},
        {"VMOV from register", "cccc11100000xxxxnnnn1010x0010000"},
        {"VMOV to register", "cccc11100001xxxxdddd1010x0010000"},
        {"VMOV from two registers, singles", "cccc11000100nnnnmmmm101000x1xxxx", is_pair},
        {"VMOV to two registers, singles", "cccc11000101eeeedddd101000x1xxxx", is_pair},
        {"VMOV from two registers", "cccc11000100nnnnmmmm101100x1xxxx"},
        {"VMOV to two registers", "cccc11000101eeeedddd101100x1xxxx"},
        {"VMOV to lane", "cccc11100xx0xxxxnnnn1011xxx10000", is_lane},
        {"VMOV from lane", "cccc1110xxx1xxxxdddd1011xxx10000", is_loaded_lane},
        {"VDUP register", "cccc11101xx0xxxxnnnn1011x0x10000", is_all_lanes},
        {"VMRS flags", "cccc1110111100011111101000010000"},
        {"VLDR", "cccc1101xx01ppppxxxx101xxxxxxxxx"},
        {"VLDR literal", "cccc1101xx011111xxxx101xxxxxxxxx"},
        {"VSTR", "cccc1101xx00ppppxxxx101xxxxxxxxx"},
        {"VLDM", "cccc110xxxx1ppppxxxx101xxxxxxxxx", is_multiple},
        {"VSTM", "cccc110xxxx0ppppxxxx101xxxxxxxxx", is_multiple},
    };
    return table;
}

// The condition of VFP is AL, NEON has two spaces.
std::uint32_t to_thumb(std::uint32_t w) {
    if (w >> 25 == 0x79) return 0xEF000000 | (w & 0x00FFFFFF) | bit(w, 24) << 28;
    if (w >> 24 == 0xF4) return 0xF9000000 | (w & 0x00FFFFFF);
    return 0xE0000000 | (w & 0x0FFFFFFF);
}

}  // namespace tb::core
