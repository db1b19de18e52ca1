// scan_codes_test.cpp - scan code set 2, from IBM's table of a US keyboard.
#include <gmock/gmock.h>

#include <set>
#include <utility>

#include "sim/board/scan_codes.h"

namespace {

using namespace sim;
using testing::ElementsAre;
using testing::IsEmpty;

TEST(ScanCodes, AreThoseOfTheTable) {
    const std::pair<char, int> keys[] = {{'a', 0x1C},  {'q', 0x15}, {'z', 0x1A}, {'m', 0x3A},
                                         {'0', 0x45},  {'9', 0x46}, {' ', 0x29}, {'\n', 0x5A},
                                         {'\t', 0x0D}, {'`', 0x0E}, {'=', 0x55}, {'\\', 0x5D},
                                         {'\'', 0x52}, {'/', 0x4A}, {'p', 0x4D}, {'h', 0x33}};
    for (const auto& [character, code] : keys) {
        ASSERT_TRUE(stroke(character)) << character;
        EXPECT_EQ(stroke(character)->key, code) << character;
        EXPECT_FALSE(stroke(character)->shift) << character;
    }
}

TEST(ScanCodes, NeedShiftForCapitalsAndUpperSymbols) {
    const std::pair<char, char> keys[] = {{'A', 'a'}, {'Z', 'z'},  {'!', '1'},  {')', '0'},
                                          {'?', '/'}, {'"', '\''}, {'|', '\\'}, {'~', '`'}};
    for (const auto& [shifted, plain] : keys) {
        EXPECT_TRUE(stroke(shifted)->shift) << shifted;
        EXPECT_EQ(stroke(shifted)->key, stroke(plain)->key) << shifted;
    }
}

TEST(ScanCodes, AreThereForAllPrintableCharactersAndNoOthers) {
    std::set<std::pair<int, bool>> seen;
    for (int c = -128; c < 128; ++c) {
        const auto strike = stroke(static_cast<char>(c));
        EXPECT_EQ(strike.has_value(), (c >= ' ' && c <= '~') || c == '\n' || c == '\t') << c;
        if (!strike) continue;
        EXPECT_TRUE(seen.emplace(strike->key, strike->shift).second) << c;
    }
}

Codes made_by(const std::string& name) {
    for (const Key& key : keys())
        if (key.name == name) return make_code(key.code);
    return {};
}

TEST(ScanCodes, OfKeysByNameAreThoseOfTheTable) {
    EXPECT_THAT(made_by("Esc"), ElementsAre(0x76));
    EXPECT_THAT(made_by("F7"), ElementsAre(0x83));
    EXPECT_THAT(made_by("F12"), ElementsAre(0x07));
    EXPECT_THAT(made_by("Backspace"), ElementsAre(0x66));
    EXPECT_THAT(made_by("Enter"), ElementsAre(0x5A));
    EXPECT_THAT(made_by("NumpadEnter"), ElementsAre(0xE0, 0x5A));
    EXPECT_THAT(made_by("Shift"), ElementsAre(0x12));
    EXPECT_THAT(made_by("RightShift"), ElementsAre(0x59));
    EXPECT_THAT(made_by("Ctrl"), ElementsAre(0x14));
    EXPECT_THAT(made_by("RightCtrl"), ElementsAre(0xE0, 0x14));
    EXPECT_THAT(made_by("RightAlt"), ElementsAre(0xE0, 0x11));
    EXPECT_THAT(made_by("Up"), ElementsAre(0xE0, 0x75));
    EXPECT_THAT(made_by("Left"), ElementsAre(0xE0, 0x6B));
    EXPECT_THAT(made_by("Down"), ElementsAre(0xE0, 0x72));
    EXPECT_THAT(made_by("Right"), ElementsAre(0xE0, 0x74));
    EXPECT_THAT(made_by("PageUp"), ElementsAre(0xE0, 0x7D));
    EXPECT_THAT(made_by("Delete"), ElementsAre(0xE0, 0x71));
    EXPECT_THAT(made_by("NumpadPoint"), ElementsAre(0x71));
    EXPECT_THAT(made_by("Numpad5"), ElementsAre(0x73));
    EXPECT_THAT(made_by("NumpadSlash"), ElementsAre(0xE0, 0x4A));
    EXPECT_THAT(made_by("a"), ElementsAre(0x1C));
    EXPECT_THAT(made_by("/"), ElementsAre(0x4A));
}

TEST(ScanCodes, AreOnePerKeyOf104) {
    std::set<std::string> names;
    std::set<int> codes;
    for (const Key& key : keys()) {
        EXPECT_TRUE(names.insert(key.name).second) << key.name;
        EXPECT_TRUE(codes.insert(key.code).second) << key.name;
    }
    EXPECT_EQ(codes.size(), 104u);
}

TEST(ScanCodes, GoUpWithF0BeforeTheByte) {
    EXPECT_THAT(break_code(0x1C), ElementsAre(0xF0, 0x1C));
    EXPECT_THAT(break_code(0xE075), ElementsAre(0xE0, 0xF0, 0x75));
    EXPECT_THAT(repeat_code(0xE075), ElementsAre(0xE0, 0x75));
}

TEST(ScanCodes, ArePeculiarForPauseAndPrintScreen) {
    EXPECT_THAT(made_by("Pause"), ElementsAre(0xE1, 0x14, 0x77, 0xE1, 0xF0, 0x14, 0xF0, 0x77));
    EXPECT_THAT(break_code(PAUSE), IsEmpty());
    EXPECT_THAT(repeat_code(PAUSE), IsEmpty());
    EXPECT_THAT(made_by("PrintScreen"), ElementsAre(0xE0, 0x12, 0xE0, 0x7C));
    EXPECT_THAT(repeat_code(PRINT_SCREEN), ElementsAre(0xE0, 0x7C));
    EXPECT_THAT(break_code(PRINT_SCREEN), ElementsAre(0xE0, 0xF0, 0x7C, 0xE0, 0xF0, 0x12));
}

}  // namespace
