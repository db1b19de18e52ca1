// scan_codes_test.cpp - scan code set 2, from IBM's table of a US keyboard.
#include <gtest/gtest.h>

#include <set>
#include <utility>

#include "sim/board/scan_codes.h"

namespace {

using sim::scan_code;

TEST(ScanCodes, AreThoseOfTheTable) {
    const std::pair<char, int> keys[] = {{'a', 0x1C},  {'q', 0x15}, {'z', 0x1A}, {'m', 0x3A},
                                         {'0', 0x45},  {'9', 0x46}, {' ', 0x29}, {'\n', 0x5A},
                                         {'\t', 0x0D}, {'`', 0x0E}, {'=', 0x55}, {'\\', 0x5D},
                                         {'\'', 0x52}, {'/', 0x4A}, {'p', 0x4D}, {'h', 0x33}};
    for (const auto& [character, code] : keys) {
        ASSERT_TRUE(scan_code(character)) << character;
        EXPECT_EQ(scan_code(character)->code, code) << character;
        EXPECT_FALSE(scan_code(character)->shift) << character;
    }
}

TEST(ScanCodes, NeedShiftForCapitalsAndUpperSymbols) {
    const std::pair<char, char> keys[] = {{'A', 'a'}, {'Z', 'z'},  {'!', '1'},  {')', '0'},
                                          {'?', '/'}, {'"', '\''}, {'|', '\\'}, {'~', '`'}};
    for (const auto& [shifted, plain] : keys) {
        EXPECT_TRUE(scan_code(shifted)->shift) << shifted;
        EXPECT_EQ(scan_code(shifted)->code, scan_code(plain)->code) << shifted;
    }
}

TEST(ScanCodes, AreThereForAllPrintableCharactersAndNoOthers) {
    std::set<std::pair<int, bool>> seen;
    for (int c = -128; c < 128; ++c) {
        const auto code = scan_code(static_cast<char>(c));
        EXPECT_EQ(code.has_value(), (c >= ' ' && c <= '~') || c == '\n' || c == '\t') << c;
        if (!code) continue;
        EXPECT_TRUE(seen.emplace(code->code, code->shift).second) << c;
    }
}

}  // namespace
