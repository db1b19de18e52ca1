// Random ARM instructions: data processing and media instructions, loads and stores.
#include "tb/sim/arm_core/encodings.h"

namespace tb::core {

namespace {

using Word = std::uint32_t;

bool is_computing(Word w) {  // AND - RSC, ORR, BIC: a result and two operands
    const Word op = field(w, 24, 21);
    return op < 8 || op == 12 || op == 14;
}
bool has_mask(Word w) { return field(w, 19, 18) != 0; }
bool is_extension(Word w) { return field(w, 21, 20) != 1; }
bool is_parallel(Word w) {
    const Word op = field(w, 7, 5);
    return field(w, 21, 20) != 0 && (op <= 4 || op == 7);
}
bool is_bit_range(Word w) { return field(w, 20, 16) >= field(w, 11, 7); }
bool is_bit_width(Word w) { return field(w, 20, 16) + field(w, 11, 7) < 32; }

// ---- Loads and stores ----

bool writes_back(Word w) { return !bit(w, 24) || bit(w, 21); }
bool is_mode(Word w) { return bit(w, 24) || !bit(w, 21); }  // post-indexed with W: LDRT's kind
bool stores_no_base(Word w) {
    return is_mode(w) && !(writes_back(w) && field(w, 15, 12) == field(w, 19, 16));
}
bool is_small_shift(Word w) {
    const Word type = field(w, 6, 5), by = field(w, 11, 7);
    return is_mode(w) && (type == 0 ? by <= 4 : type != 3 || by == 0);
}
bool is_large_shift(Word w) {
    const Word type = field(w, 6, 5), by = field(w, 11, 7);
    return is_mode(w) && type != 0 && by >= 22 && (type != 3 || by == 22);
}
bool is_other_base(Word w) { return field(w, 15, 12) != field(w, 19, 16); }
bool is_extra(Word w) { return is_mode(w) && field(w, 6, 5) != 0; }
bool stores_pair(Word w) {
    const Word t = field(w, 15, 12), base = field(w, 19, 16);
    return is_mode(w) && !(writes_back(w) && (t == base || t + 1 == base));
}
bool has_list(Word w) { return field(w, 15, 0) != 0; }
bool has_store_list(Word w) { return has_list(w) && !(bit(w, 21) && bit(w, field(w, 19, 16))); }

}  // namespace

const std::vector<Encoding>& arm_encodings() {
    static const std::vector<Encoding> table{
        {"AND..BIC immediate", "cccc001xxxxxNNNNddddxxxxxxxxxxxx", is_computing},
        {"AND..BIC register", "cccc000xxxxxNNNNddddxxxxxxx0MMMM", is_computing},
        {"AND..BIC shifted by register", "cccc000xxxxxnnnnddddssss0xx1mmmm", is_computing},
        {"MOV MVN immediate", "cccc00111x1x0000ddddxxxxxxxxxxxx"},
        {"MOV MVN register", "cccc00011x1x0000ddddxxxxxxx0MMMM"},
        {"MOV MVN shifted by register", "cccc00011x1x0000ddddssss0xx1mmmm"},
        {"TST TEQ CMP CMN immediate", "cccc00110xx1NNNN0000xxxxxxxxxxxx"},
        {"TST TEQ CMP CMN register", "cccc00010xx1NNNN0000xxxxxxx0MMMM"},
        {"TST TEQ CMP CMN shifted by register", "cccc00010xx1nnnn0000ssss0xx1mmmm"},
        {"MOVW MOVT", "cccc00110x00xxxxddddxxxxxxxxxxxx"},
        {"MUL", "cccc0000000xdddd0000ssss1001mmmm"},
        {"MLA", "cccc0000001xddddaaaassss1001mmmm"},
        {"MLS", "cccc00000110ddddaaaassss1001mmmm"},
        {"UMAAL", "cccc00000100eeeeddddssss1001mmmm"},
        {"UMULL UMLAL SMULL SMLAL", "cccc00001xxxeeeeddddssss1001mmmm"},
        {"SMLAxy", "cccc00010000ddddaaaassss1xx0mmmm"},
        {"SMLAWy", "cccc00010010ddddaaaassss1x00mmmm"},
        {"SMULWy", "cccc00010010dddd0000ssss1x10mmmm"},
        {"SMLALxy", "cccc00010100eeeeddddssss1xx0mmmm"},
        {"SMULxy", "cccc00010110dddd0000ssss1xx0mmmm"},
        {"SMLAD SMLSD", "cccc01110000ddddaaaassss0xx1mmmm"},
        {"SMUAD SMUSD", "cccc01110000dddd1111ssss0xx1mmmm"},
        {"SMLALD SMLSLD", "cccc01110100eeeeddddssss0xx1mmmm"},
        {"SMMUL", "cccc01110101dddd1111ssss00x1mmmm"},
        {"SMMLA", "cccc01110101ddddaaaassss00x1mmmm"},
        {"SMMLS", "cccc01110101ddddaaaassss11x1mmmm"},
        {"USAD8", "cccc01111000dddd1111ssss0001mmmm"},
        {"USADA8", "cccc01111000ddddaaaassss0001mmmm"},
        {"QADD QSUB QDADD QDSUB", "cccc00010xx0nnnndddd00000101mmmm"},
        {"SSAT", "cccc0110101xxxxxddddxxxxxx01mmmm"},
        {"USAT", "cccc0110111xxxxxddddxxxxxx01mmmm"},
        {"SSAT16", "cccc01101010xxxxdddd11110011mmmm"},
        {"USAT16", "cccc01101110xxxxdddd11110011mmmm"},
        {"SXTB UXTB", "cccc01101xxx1111ddddxx000111mmmm", is_extension},
        {"SXTAB UXTAB", "cccc01101xxxnnnnddddxx000111mmmm", is_extension},
        {"PKH", "cccc01101000nnnnddddxxxxxx01mmmm"},
        {"SEL", "cccc01101000nnnndddd11111011mmmm"},
        {"REV REV16", "cccc011010111111dddd1111x011mmmm"},
        {"RBIT REVSH", "cccc011011111111dddd1111x011mmmm"},
        {"CLZ", "cccc000101101111dddd11110001mmmm"},
        {"SADD8 .. UHSUB16", "cccc01100xxxnnnndddd1111xxx1mmmm", is_parallel},
        {"BFC", "cccc0111110xxxxxddddxxxxx0011111", is_bit_range},
        {"BFI", "cccc0111110xxxxxddddxxxxx001mmmm", is_bit_range},
        {"SBFX UBFX", "cccc01111x1xxxxxddddxxxxx101nnnn", is_bit_width},
        {"MRS", "cccc000100001111dddd000000000000"},
        {"MSR register", "cccc00010010xx00111100000000mmmm", has_mask},
        {"MSR immediate", "cccc00110010xx001111xxxxxxxxxxxx", has_mask},
        {"NOP", "cccc0011001000001111000000000000"},
        {"DSB", "11110101011111111111000001001111"},
        {"DMB", "11110101011111111111000001011111"},
        {"ISB", "11110101011111111111000001101111"},
    };
    return table;
}

const std::vector<Encoding>& arm_memory_encodings() {
    static const std::vector<Encoding> table{
        {"LDR LDRB immediate", "cccc010xxxx1qqqqddddxxxxxxxxxxxx", is_mode},
        {"LDR LDRB register", "cccc011xxxx1qqqqddddxxxxxxx0iiii", is_small_shift},
        {"LDR LDRB register, large shift", "cccc011xxxx1qqqqddddxxxxxxx0kkkk", is_large_shift},
        {"LDR LDRB literal", "cccc0101xx011111ddddxxxxxxxxxxxx"},
        {"STR STRB immediate", "cccc010xxxx0qqqqnnnnxxxxxxxxxxxx", stores_no_base},
        {"STR pc", "cccc0101x000qqqq1111xxxxxxxxxxxx"},
        {"STR STRB register", "cccc011xxxx0qqqqnnnnxxxxxxx0iiii",
         [](Word w) { return is_small_shift(w) && stores_no_base(w); }},
        {"STR STRB register, large shift", "cccc011xxxx0qqqqnnnnxxxxxxx0kkkk",
         [](Word w) { return is_large_shift(w) && stores_no_base(w); }},
        {"LDRT LDRBT immediate", "cccc0100xx11qqqqddddxxxxxxxxxxxx"},
        {"LDRT LDRBT register", "cccc0110xx11qqqqddddxxxxxxx0iiii",
         [](Word w) { return is_small_shift(w | 1u << 24); }},
        {"STRT STRBT immediate", "cccc0100xx10qqqqnnnnxxxxxxxxxxxx", is_other_base},
        {"STRT STRBT register", "cccc0110xx10qqqqnnnnxxxxxxx0iiii",
         [](Word w) { return is_small_shift(w | 1u << 24) && is_other_base(w); }},
        {"LDRHT LDRSBT LDRSHT immediate", "cccc0000x111qqqqddddxxxx1xx1xxxx",
         [](Word w) { return field(w, 6, 5) != 0; }},
        {"LDRHT LDRSBT LDRSHT register", "cccc0000x011qqqqdddd00001xx1iiii",
         [](Word w) { return field(w, 6, 5) != 0; }},
        {"STRHT immediate", "cccc0000x110qqqqnnnnxxxx1011xxxx", is_other_base},
        {"STRHT register", "cccc0000x010qqqqnnnn00001011iiii", is_other_base},
        {"LDRH LDRSB LDRSH immediate", "cccc000xx1x1qqqqddddxxxx1xx1xxxx", is_extra},
        {"LDRH LDRSB LDRSH register", "cccc000xx0x1qqqqdddd00001xx1iiii", is_extra},
        {"LDRH LDRSB LDRSH literal", "cccc0001x1011111ddddxxxx1xx1xxxx", is_extra},
        {"STRH immediate", "cccc000xx1x0qqqqnnnnxxxx1011xxxx", stores_no_base},
        {"STRH register", "cccc000xx0x0qqqqnnnn00001011iiii", stores_no_base},
        {"LDRD immediate", "cccc000xx1x0pppprrrrxxxx1101xx00", is_mode},
        {"LDRD register", "cccc000xx0x0pppprrrr00001101iiii", is_mode},
        {"LDRD literal", "cccc0001x1001111rrrrxxxx1101xx00"},
        {"STRD immediate", "cccc000xx1x0ppppooooxxxx1111xx00", stores_pair},
        {"STRD register", "cccc000xx0x0ppppoooo00001111iiii", stores_pair},
        {"LDM", "cccc100xx0x1ppppllllllllllllllll", has_list},
        {"STM", "cccc100xx0x0ppppLLLLLLLLLLLLLLLL", has_store_list},
        {"PLD", "11110101x101qqqq1111xxxxxxxxxxxx"},
        {"PLI", "11110100x101qqqq1111xxxxxxxxxxxx"},
        {"CLREX", "11110101011111111111000000011111"},
    };
    return table;
}

}  // namespace tb::core
