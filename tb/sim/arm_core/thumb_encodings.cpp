// Random Thumb instructions of 16 and 32 bits: data processing and media, loads and stores.
#include "tb/sim/arm_core/encodings.h"

namespace tb::core {

namespace {

using Word = std::uint32_t;

bool is_shift(Word w) { return field(w, 12, 11) != 3 && field(w, 12, 6) != 0; }
bool has_high(Word w) { return bit(w, 7) || bit(w, 6); }

// AND BIC ORR ORN EOR ADD ADC SBC SUB RSB
bool is_computing(Word w) { return 0x6D1F >> field(w, 24, 21) & 1; }
bool is_testing(Word w) { return 0x2111 >> field(w, 24, 21) & 1; }  // TST TEQ CMN CMP
// Not the UNPREDICTABLE ones of zero bytes that are repeated.
bool is_constant(Word w) {
    const Word how = bit(w, 26) << 3 | field(w, 14, 12);
    return how == 0 || how > 3 || (w & 0xFF) != 0;
}
bool is_saturation(Word w) { return !bit(w, 21) || (w & 0x70C0) != 0; }
bool is_bit_range(Word w) { return field(w, 4, 0) >= (field(w, 14, 12) << 2 | field(w, 7, 6)); }
bool is_bit_width(Word w) { return field(w, 4, 0) + (field(w, 14, 12) << 2 | field(w, 7, 6)) < 32; }
bool is_extension(Word w) { return field(w, 22, 20) <= 5; }
bool is_parallel(Word w) {
    const Word op = field(w, 22, 20);
    return op != 3 && op != 7 && field(w, 5, 4) != 3;
}
bool has_mask(Word w) { return field(w, 11, 10) != 0; }

// ---- Loads and stores ----

bool has_list8(Word w) { return (w & 0xFF) != 0; }
bool has_store_list8(Word w) { return has_list8(w) && !bit(w, field(w, 10, 8)); }
bool is_size(Word w) { return field(w, 22, 21) != 3; }
bool is_signed_size(Word w) { return !bit(w, 22); }
// Offset below, post- or pre-indexed; not LDRT's kind.
bool is_mode(Word w) { return is_size(w) && (bit(w, 10) || bit(w, 8)) && field(w, 10, 8) != 6; }
bool is_signed_mode(Word w) { return is_signed_size(w) && is_mode(w); }
bool stores_no_base(Word w) {
    return is_mode(w) && !(bit(w, 8) && field(w, 15, 12) == field(w, 19, 16));
}
bool is_pair(Word w) { return bit(w, 24) || bit(w, 21); }
bool stores_pair(Word w) {
    const Word base = field(w, 19, 16);
    return is_pair(w) && !(bit(w, 21) && (field(w, 15, 12) == base || field(w, 11, 8) == base));
}
bool has_two(Word w) { return (w & 0xFFFF & ((w & 0xFFFF) - 1)) != 0; }
bool has_two_stored(Word w) { return has_two(w) && !bit(w, field(w, 19, 16)); }

}  // namespace

const std::vector<Encoding>& thumb_encodings() {
    static const std::vector<Encoding> table{
        {"LSL LSR ASR immediate", "000xxxxxxxmmmddd", is_shift},
        {"MOVS", "0000000000mmmddd"},
        {"ADD SUB register", "000110xmmmnnnddd"},
        {"ADD SUB immediate of 3 bits", "000111xxxxnnnddd"},
        {"MOV CMP ADD SUB immediate of 8 bits", "001xxdddxxxxxxxx"},
        {"AND .. MVN of 16 bits", "010000xxxxmmmddd"},
        {"ADD high", "01000100dmmmmddd"},
        {"CMP high", "01000101nmmmmnnn", has_high},
        {"MOV high", "01000110dmmmmddd"},
        {"ADR ADD sp of 16 bits", "1010xdddxxxxxxxx"},
        {"ADD SUB sp", "10110000xxxxxxxx"},
        {"SXTH SXTB UXTH UXTB of 16 bits", "10110010xxmmmddd"},
        {"REV REV16 of 16 bits", "101110100xmmmddd"},
        {"REVSH of 16 bits", "1011101011mmmddd"},
        {"NOP", "1011111100000000"},
        {"AND..RSB constant", "11110x0xxxxxnnnn0xxxddddxxxxxxxx",
         [](Word w) { return is_computing(w) && is_constant(w); }},
        {"MOV MVN constant", "11110x0001xx11110xxxddddxxxxxxxx", is_constant},
        {"TST TEQ CMN CMP constant", "11110x0xxxx1nnnn0xxx1111xxxxxxxx",
         [](Word w) { return is_testing(w) && is_constant(w); }},
        {"AND..RSB register", "1110101xxxxxnnnn0xxxddddxxxxmmmm", is_computing},
        {"MOV MVN register", "1110101001xx11110xxxddddxxxxmmmm"},
        {"TST TEQ CMN CMP register", "1110101xxxx1nnnn0xxx1111xxxxmmmm", is_testing},
        {"PKH", "111010101100nnnn0xxxddddxxx0mmmm"},
        {"ADDW", "11110x100000nnnn0xxxddddxxxxxxxx"},
        {"SUBW", "11110x101010nnnn0xxxddddxxxxxxxx"},
        {"ADR after", "11110x10000011110xxxddddxxxxxxxx"},
        {"ADR before", "11110x10101011110xxxddddxxxxxxxx"},
        {"MOVW MOVT", "11110x10x100xxxx0xxxddddxxxxxxxx"},
        {"SSAT USAT", "11110011x0x0nnnn0xxxddddxx0xxxxx", is_saturation},
        {"SSAT16 USAT16", "11110011x010nnnn0000dddd0000xxxx"},
        {"SBFX UBFX", "11110011x100nnnn0xxxddddxx0xxxxx", is_bit_width},
        {"BFI", "111100110110nnnn0xxxddddxx0xxxxx", is_bit_range},
        {"BFC", "11110011011011110xxxddddxx0xxxxx", is_bit_range},
        {"LSL LSR ASR ROR register", "111110100xxxmmmm1111dddd0000ssss"},
        {"SXTB UXTB", "111110100xxx11111111dddd10xxmmmm", is_extension},
        {"SXTAB UXTAB", "111110100xxxnnnn1111dddd10xxmmmm", is_extension},
        {"SADD8 .. UHSUB16", "111110101xxxnnnn1111dddd0xxxmmmm", is_parallel},
        {"QADD QSUB QDADD QDSUB", "111110101000nnnn1111dddd10xxmmmm"},
        {"REV REV16 RBIT REVSH", "111110101001mmmm1111dddd10xxmmmm"},
        {"SEL", "111110101010nnnn1111dddd1000mmmm"},
        {"CLZ", "111110101011mmmm1111dddd1000mmmm"},
        {"MUL", "111110110000nnnn1111dddd0000mmmm"},
        {"MLA MLS", "111110110000nnnnaaaadddd000xmmmm"},
        {"SMULxy", "111110110001nnnn1111dddd00xxmmmm"},
        {"SMLAxy", "111110110001nnnnaaaadddd00xxmmmm"},
        {"SMUAD", "111110110010nnnn1111dddd000xmmmm"},
        {"SMLAD", "111110110010nnnnaaaadddd000xmmmm"},
        {"SMULWy", "111110110011nnnn1111dddd000xmmmm"},
        {"SMLAWy", "111110110011nnnnaaaadddd000xmmmm"},
        {"SMUSD", "111110110100nnnn1111dddd000xmmmm"},
        {"SMLSD", "111110110100nnnnaaaadddd000xmmmm"},
        {"SMMUL", "111110110101nnnn1111dddd000xmmmm"},
        {"SMMLA", "111110110101nnnnaaaadddd000xmmmm"},
        {"SMMLS", "111110110110nnnnaaaadddd000xmmmm"},
        {"USAD8", "111110110111nnnn1111dddd0000mmmm"},
        {"USADA8", "111110110111nnnnaaaadddd0000mmmm"},
        {"SMULL UMULL", "1111101110x0nnnnddddeeee0000mmmm"},
        {"SMLAL UMLAL", "1111101111x0nnnnddddeeee0000mmmm"},
        {"SMLALxy", "111110111100nnnnddddeeee10xxmmmm"},
        {"SMLALD SMLSLD", "11111011110xnnnnddddeeee110xmmmm"},
        {"UMAAL", "111110111110nnnnddddeeee0110mmmm"},
        {"MRS", "11110011111011111000dddd00000000"},
        {"MSR", "111100111000nnnn1000xx0000000000", has_mask},
        {"DSB DMB", "11110011101111111000111101xx1111", [](Word w) { return field(w, 5, 4) < 2; }},
        {"ISB", "11110011101111111000111101101111"},
    };
    return table;
}

const std::vector<Encoding>& thumb_memory_encodings() {
    static const std::vector<Encoding> table{
        {"LDR literal of 16 bits", "01001dddxxxxxxxx"},
        {"STR STRH register of 16 bits", "010100xiiiqqqnnn"},
        {"STRB register of 16 bits", "0101010iiiqqqnnn"},
        {"LDRSB register of 16 bits", "0101011iiiqqqddd"},
        {"LDR LDRH LDRB LDRSH register of 16 bits", "01011xxiiiqqqddd"},
        {"STR STRB immediate of 16 bits", "011x0xxxxxqqqnnn"},
        {"LDR LDRB immediate of 16 bits", "011x1xxxxxqqqddd"},
        {"STRH immediate of 16 bits", "10000xxxxxqqqnnn"},
        {"LDRH immediate of 16 bits", "10001xxxxxqqqddd"},
        {"STR sp", "10010nnnxxxxxxxx"},
        {"LDR sp", "10011dddxxxxxxxx"},
        {"PUSH", "1011010xLLLLLLLL", has_list8},
        {"POP", "10111100llllllll", has_list8},
        {"STM of 16 bits", "11000pppLLLLLLLL", has_store_list8},
        {"LDM of 16 bits", "11001pppllllllll", has_list8},
        {"LDRB LDRH LDR immediate of 12 bits", "111110001xx1qqqqddddxxxxxxxxxxxx", is_size},
        {"LDRSB LDRSH immediate of 12 bits", "111110011xx1qqqqddddxxxxxxxxxxxx", is_signed_size},
        {"LDRB LDRH LDR immediate of 8 bits", "111110000xx1qqqqdddd1xxxxxxxxxxx", is_mode},
        {"LDRSB LDRSH immediate of 8 bits", "111110010xx1qqqqdddd1xxxxxxxxxxx", is_signed_mode},
        {"LDRBT LDRHT LDRT", "111110000xx1qqqqdddd1110xxxxxxxx", is_size},
        {"LDRSBT LDRSHT", "111110010xx1qqqqdddd1110xxxxxxxx", is_signed_size},
        {"STRBT STRHT STRT", "111110000xx0qqqqnnnn1110xxxxxxxx", is_size},
        {"LDRB LDRH LDR register", "111110000xx1qqqqdddd000000xxiiii", is_size},
        {"LDRSB LDRSH register", "111110010xx1qqqqdddd000000xxiiii", is_signed_size},
        {"LDRB LDRH LDR literal", "11111000xxx11111ddddxxxxxxxxxxxx", is_size},
        {"LDRSB LDRSH literal", "11111001xxx11111ddddxxxxxxxxxxxx", is_signed_size},
        {"STRB STRH STR immediate of 12 bits", "111110001xx0qqqqnnnnxxxxxxxxxxxx", is_size},
        {"STRB STRH STR immediate of 8 bits", "111110000xx0qqqqnnnn1xxxxxxxxxxx", stores_no_base},
        {"STRB STRH STR register", "111110000xx0qqqqnnnn000000xxiiii", is_size},
        {"LDRD", "1110100xx1x1ppppddddeeeexxxxxxxx", is_pair},
        {"LDRD literal", "11101001x1011111ddddeeeexxxxxxxx"},
        {"STRD", "1110100xx1x0ppppnnnnssssxxxxxxxx", stores_pair},
        {"LDM", "1110100010x1ppppllllllllllllllll", has_two},
        {"LDMDB", "1110100100x1ppppllllllllllllllll", has_two},
        {"STM", "1110100010x0ppppLLLLLLLLLLLLLLLL", has_two_stored},
        {"STMDB", "1110100100x0ppppLLLLLLLLLLLLLLLL", has_two_stored},
        {"PLD", "111110001001qqqq1111xxxxxxxxxxxx"},
        {"CLREX", "11110011101111111000111100101111"},
    };
    return table;
}

}  // namespace tb::core
