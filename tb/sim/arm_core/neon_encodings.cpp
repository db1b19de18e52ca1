// Random NEON instructions, in ARM's encodings.
#include "tb/sim/arm_core/encodings.h"

namespace tb::core {

namespace {

using Word = std::uint32_t;

// With Q, all three or two registers are even.
bool even3(Word w) { return !bit(w, 6) || !(bit(w, 12) || bit(w, 16) || bit(w, 0)); }
bool even2(Word w) { return !bit(w, 6) || !(bit(w, 12) || bit(w, 0)); }
bool sized3(Word w) { return even3(w) && field(w, 21, 20) != 3; }
bool product(Word w) { return sized3(w) && (!bit(w, 24) || field(w, 21, 20) == 0); }
bool doubling(Word w) { return even3(w) && (field(w, 21, 20) == 1 || field(w, 21, 20) == 2); }
bool sized_pair(Word w) { return field(w, 21, 20) != 3; }

// ---- Different lengths, scalars ----

bool lengthened(Word w) { return field(w, 21, 20) != 3 && !bit(w, 12); }
bool widened(Word w) { return lengthened(w) && !bit(w, 16); }
bool scalar_size(Word w) { return field(w, 21, 20) == 1 || field(w, 21, 20) == 2; }
bool scalar(Word w) { return scalar_size(w) && (!bit(w, 24) || !(bit(w, 12) || bit(w, 16))); }
bool float_scalar(Word w) { return scalar(w) && field(w, 21, 20) == 2; }
bool long_scalar(Word w) { return scalar_size(w) && !bit(w, 12); }

// ---- Shifts: the immediate's highest bit says the size, L alone 64 bits ----

bool shift(Word w) { return even2(w) && (bit(w, 7) || field(w, 21, 19) != 0); }
bool narrowed(Word w) { return field(w, 21, 19) != 0 && !bit(w, 0); }
bool shift_longer(Word w) { return field(w, 21, 19) != 0 && !bit(w, 12); }
bool fixed(Word w) { return even2(w) && bit(w, 21); }

// ---- Two registers; what exchanges is not given the same one twice ----

unsigned size(Word w) { return field(w, 19, 18); }
bool two(Word w) { return even2(w) && size(w) != 3; }
bool bytes(Word w) { return even2(w) && size(w) == 0; }
bool words(Word w) { return even2(w) && size(w) == 2; }
bool reversed(Word w) { return even2(w) && size(w) + field(w, 8, 7) < 3; }
bool zero_compared(Word w) { return even2(w) && (bit(w, 10) ? size(w) == 2 : size(w) != 3); }
bool different(Word w) {
    return (field(w, 15, 12) | bit(w, 22) << 4) != (field(w, 3, 0) | bit(w, 5) << 4);
}
bool exchanged(Word w) { return two(w) && different(w); }
bool zipped(Word w) { return exchanged(w) && (bit(w, 6) || size(w) != 2); }
bool narrow(Word w) { return size(w) != 3 && !bit(w, 0); }
bool longer(Word w) { return size(w) != 3 && !bit(w, 12); }
// Not the UNPREDICTABLE ones, a zero byte that is shifted.
bool constant(Word w) {
    const Word mode = field(w, 11, 8), byte = bit(w, 24) << 7 | field(w, 18, 16) << 4 | (w & 0xF);
    const bool shifted = (mode < 8 && (mode & 6) != 0) || (mode & 14) == 10 || (mode & 14) == 12;
    return !(bit(w, 6) && bit(w, 12)) && !(mode == 15 && bit(w, 5)) && !(shifted && byte == 0);
}
bool extracted(Word w) { return even3(w) && (bit(w, 6) || !bit(w, 11)); }
bool table_fits(Word w) { return (field(w, 19, 16) | bit(w, 7) << 4) + field(w, 9, 8) < 32; }
bool lane_of(Word w) { return !(bit(w, 6) && bit(w, 12)) && field(w, 18, 16) != 0; }

}  // namespace

const std::vector<Encoding>& neon_encodings() {
    static const std::vector<Encoding> table{
        {"VHADD VHSUB", "1111001x0xxxxxxxxxxx00x0xxx0xxxx", sized3},
        {"VQADD VQSUB", "1111001x0xxxxxxxxxxx00x0xxx1xxxx", sized3},
        {"VQADD VQSUB of 64 bits", "1111001x0x11xxxxxxxx00x0xxx1xxxx", even3},
        {"VRHADD", "1111001x0xxxxxxxxxxx0001xxx0xxxx", sized3},
        {"VAND .. VBIF", "1111001x0xxxxxxxxxxx0001xxx1xxxx", even3},
        {"VCGT VCGE", "1111001x0xxxxxxxxxxx0011xxxxxxxx", sized3},
        {"VSHL register", "1111001x0xxxxxxxxxxx0100xxx0xxxx", even3},
        {"VQSHL register", "1111001x0xxxxxxxxxxx0100xxx1xxxx", even3},
        {"VRSHL", "1111001x0xxxxxxxxxxx0101xxx0xxxx", even3},
        {"VQRSHL", "1111001x0xxxxxxxxxxx0101xxx1xxxx", even3},
        {"VMAX VMIN", "1111001x0xxxxxxxxxxx0110xxxxxxxx", sized3},
        {"VABD VABA", "1111001x0xxxxxxxxxxx0111xxxxxxxx", sized3},
        {"VADD VSUB", "1111001x0xxxxxxxxxxx1000xxx0xxxx", even3},
        {"VTST VCEQ", "1111001x0xxxxxxxxxxx1000xxx1xxxx", sized3},
        {"VMLA VMLS", "1111001x0xxxxxxxxxxx1001xxx0xxxx", sized3},
        {"VMUL", "1111001x0xxxxxxxxxxx1001xxx1xxxx", product},
        {"VPMAX VPMIN", "1111001x0xxxxxxxxxxx1010x0xxxxxx", sized_pair},
        {"VQDMULH VQRDMULH", "1111001x0xxxxxxxxxxx1011xxx0xxxx", doubling},
        {"VPADD", "111100100xxxxxxxxxxx1011x0x1xxxx", sized_pair},
        {"VADD VSUB float", "111100100xx0xxxxxxxx1101xxx0xxxx", even3},
        {"VPADD float", "111100110x00xxxxxxxx1101x0x0xxxx"},
        {"VABD float", "111100110x10xxxxxxxx1101xxx0xxxx", even3},
        {"VMLA VMLS float", "111100100xx0xxxxxxxx1101xxx1xxxx", even3},
        {"VMUL float", "111100110x00xxxxxxxx1101xxx1xxxx", even3},
        {"VCEQ float", "111100100x00xxxxxxxx1110xxx0xxxx", even3},
        {"VCGE VCGT float", "111100110xx0xxxxxxxx1110xxx0xxxx", even3},
        {"VACGE VACGT", "111100110xx0xxxxxxxx1110xxx1xxxx", even3},
        {"VMAX VMIN float", "111100100xx0xxxxxxxx1111xxx0xxxx", even3},
        {"VPMAX VPMIN float", "111100110xx0xxxxxxxx1111x0x0xxxx"},
        {"VRECPS VRSQRTS", "111100100xx0xxxxxxxx1111xxx1xxxx", even3},
        {"VADDL VSUBL", "1111001x1xxxxxxxxxxx00x0x0x0xxxx", lengthened},
        {"VADDW VSUBW", "1111001x1xxxxxxxxxxx00x1x0x0xxxx", widened},
        {"VADDHN VSUBHN", "1111001x1xxxxxx0xxxx01x0x0x0xxxx",
         [](Word w) { return sized_pair(w) && !bit(w, 0); }},
        {"VABAL VABDL", "1111001x1xxxxxxxxxxx01x1x0x0xxxx", lengthened},
        {"VMLAL VMLSL", "1111001x1xxxxxxxxxxx10x0x0x0xxxx", lengthened},
        {"VMULL", "1111001x1xxxxxxxxxxx1100x0x0xxxx", lengthened},
        {"VMULL polynomial", "111100101x00xxxxxxx01110x0x0xxxx"},
        {"VQDMLAL VQDMLSL", "111100101xxxxxxxxxxx10x1x0x0xxxx", long_scalar},
        {"VQDMULL", "111100101xxxxxxxxxxx1101x0x0xxxx", long_scalar},
        {"VMLA VMLS scalar", "1111001x1xxxxxxxxxxx0x00x1x0xxxx", scalar},
        {"VMLA VMLS float scalar", "1111001x1xxxxxxxxxxx0x01x1x0xxxx", float_scalar},
        {"VMLAL VMLSL scalar", "1111001x1xxxxxxxxxxx0x10x1x0xxxx", long_scalar},
        {"VQDMLAL VQDMLSL scalar", "111100101xxxxxxxxxxx0x11x1x0xxxx", long_scalar},
        {"VMUL scalar", "1111001x1xxxxxxxxxxx1000x1x0xxxx", scalar},
        {"VMUL float scalar", "1111001x1xxxxxxxxxxx1001x1x0xxxx", float_scalar},
        {"VMULL scalar", "1111001x1xxxxxxxxxxx1010x1x0xxxx", long_scalar},
        {"VQDMULL scalar", "111100101xxxxxxxxxxx1011x1x0xxxx", long_scalar},
        {"VQDMULH VQRDMULH scalar", "1111001x1xxxxxxxxxxx110xx1x0xxxx", scalar},
        {"VSHR VSRA", "1111001x1xxxxxxxxxxx000xxxx1xxxx", shift},
        {"VRSHR VRSRA", "1111001x1xxxxxxxxxxx001xxxx1xxxx", shift},
        {"VSRI", "111100111xxxxxxxxxxx0100xxx1xxxx", shift},
        {"VSHL immediate", "111100101xxxxxxxxxxx0101xxx1xxxx", shift},
        {"VSLI", "111100111xxxxxxxxxxx0101xxx1xxxx", shift},
        {"VQSHLU", "111100111xxxxxxxxxxx0110xxx1xxxx", shift},
        {"VQSHL immediate", "1111001x1xxxxxxxxxxx0111xxx1xxxx", shift},
        {"VSHRN VRSHRN", "111100101xxxxxxxxxxx10000xx1xxxx", narrowed},
        {"VQSHRUN VQRSHRUN", "111100111xxxxxxxxxxx10000xx1xxxx", narrowed},
        {"VQSHRN VQRSHRN", "1111001x1xxxxxxxxxxx10010xx1xxxx", narrowed},
        {"VSHLL VMOVL", "1111001x1xxxxxxxxxxx101000x1xxxx", shift_longer},
        {"VCVT fixed from", "1111001x1xxxxxxxxxxx11100xx1xxxx", fixed},
        {"VCVT fixed to", "1111001x1xxxxxxxxxxx11110xx1xxxx", fixed},
        {"VREV", "111100111x11xx00xxxx000xxxx0xxxx", reversed},
        {"VPADDL", "111100111x11xx00xxxx0010xxx0xxxx", two},
        {"VCLS VCLZ", "111100111x11xx00xxxx0100xxx0xxxx", two},
        {"VCNT VMVN", "111100111x110000xxxx0101xxx0xxxx", bytes},
        {"VPADAL", "111100111x11xx00xxxx0110xxx0xxxx", two},
        {"VQABS VQNEG", "111100111x11xx00xxxx0111xxx0xxxx", two},
        {"VCGT .. VCLE zero", "111100111x11xx01xxxx0x0xxxx0xxxx", zero_compared},
        {"VCLT zero", "111100111x11xx01xxxx0x100xx0xxxx", zero_compared},
        {"VABS VNEG", "111100111x11xx01xxxx0x11xxx0xxxx", zero_compared},
        {"VSWP", "111100111x110010xxxx00000xx0xxxx",
         [](Word w) { return even2(w) && different(w); }},
        {"VTRN", "111100111x11xx10xxxx00001xx0xxxx", exchanged},
        {"VUZP VZIP", "111100111x11xx10xxxx0001xxx0xxxx", zipped},
        {"VMOVN", "111100111x11xx10xxxx001000x0xxxx", narrow},
        {"VQMOVUN", "111100111x11xx10xxxx001001x0xxxx", narrow},
        {"VQMOVN", "111100111x11xx10xxxx00101xx0xxxx", narrow},
        {"VSHLL maximum", "111100111x11xx10xxxx001100x0xxxx", longer},
        {"VCVT to half", "111100111x110110xxxx011000x0xxx0"},
        {"VCVT from half", "111100111x110110xxx0011100x0xxxx"},
        {"VRECPE VRSQRTE", "111100111x11xx11xxxx010xxxx0xxxx", words},
        {"VCVT integer", "111100111x11xx11xxxx011xxxx0xxxx", words},
        {"VMOV .. VBIC immediate", "1111001x1x000xxxxxxxxxxx0xx1xxxx", constant},
        {"VEXT", "111100101x11xxxxxxxxxxxxxxx0xxxx", extracted},
        {"VTBL VTBX", "111100111x11xxxxxxxx10xxxxx0xxxx", table_fits},
        {"VDUP lane", "111100111x11xxxxxxxx11000xx0xxxx", lane_of},
    };
    return table;
}

}  // namespace tb::core
