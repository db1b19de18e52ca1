// sim/board/keypad.cpp: the wires as a matrix without diodes gives them, and contacts that bounce.
#include "sim/board/keypad.h"

#include <gtest/gtest.h>

#include <vector>

namespace {

constexpr std::uint64_t US = 1'000'000, MS = 1000 * US;

constexpr std::uint8_t ALL_HIGH = 0xff;
std::uint16_t key(int row, int column) {
    return static_cast<std::uint16_t>(1u << (4 * row + column));
}

class KeypadModel : public ::testing::Test {
protected:
    sim::Agenda agenda;
    std::vector<std::uint64_t> moves;
    sim::Keypad keypad{agenda, 1, [this] { moves.push_back(agenda.now_ps()); }};

    void pass(std::uint64_t ps) { agenda.run_to(agenda.now_ps() + ps); }
    void settle() { pass(10 * MS); }
    // Rows D3-D0 with one column pulled low and the others floating; column 0 is D7.
    unsigned rows(int column) {
        const auto enable = static_cast<std::uint8_t>(0x80 >> column);
        return keypad.levels(0x00, enable) & 0x0fu;
    }
};

TEST_F(KeypadModel, ReadsHighEverywhereWhileNothingIsPressed) {
    settle();
    EXPECT_EQ(keypad.levels(0x00, 0x00), ALL_HIGH);
    for (int c = 0; c < 4; ++c) EXPECT_EQ(rows(c), 0xfu);
}

TEST_F(KeypadModel, ConnectsEachKeysRowAndColumn) {
    for (int r = 0; r < 4; ++r)
        for (int c = 0; c < 4; ++c) {
            keypad.press(key(r, c));
            settle();
            for (int other = 0; other < 4; ++other)
                EXPECT_EQ(rows(other), other == c ? 0xfu & ~(8u >> r) : 0xfu) << r << c << other;
            keypad.release(key(r, c));
            settle();
        }
}

TEST_F(KeypadModel, WorksFromTheRowsToTheColumnsToo) {
    keypad.press(key(1, 2));  // row wire D2, column wire D5
    settle();
    EXPECT_EQ(keypad.levels(0x00, 0x04), ALL_HIGH & ~0x04u & ~0x20u);
}

TEST_F(KeypadModel, ClosesTheFourthCornersPath) {
    keypad.press(static_cast<std::uint16_t>(key(0, 0) | key(1, 0) | key(0, 1)));
    settle();
    EXPECT_EQ(rows(1), 0xfu & ~0x8u & ~0x4u);  // row 1 looks pressed in column 1
}

TEST_F(KeypadModel, LetsALowOutputWinOverAHighOne) {
    keypad.press(static_cast<std::uint16_t>(key(0, 0) | key(0, 1)));
    settle();
    EXPECT_EQ(keypad.levels(0x70, 0xf0) & 0xf8u, 0x30u);  // D7 low; D6 driven high, pulled low
}

TEST_F(KeypadModel, BouncesForAtMostFiveMillisecondsAndThenRests) {
    for (int press = 0; press < 20; ++press) {
        const std::uint64_t begin = agenda.now_ps();
        moves.clear();
        keypad.press(key(0, 0));
        pass(20 * MS);
        ASSERT_GE(moves.size(), 3u) << "no bounce";
        EXPECT_EQ(moves.size() % 2, 1u);
        EXPECT_LE(moves.back() - begin, 5 * MS);
        EXPECT_EQ(rows(0), 0x7u);
        keypad.release(key(0, 0));
        pass(20 * MS);
        EXPECT_EQ(rows(0), 0xfu);
    }
    EXPECT_EQ(keypad.presses(), 20u);
    EXPECT_EQ(keypad.releases(), 20u);
}

TEST_F(KeypadModel, BouncesByItsSeed) {
    std::vector<std::uint64_t> same_moves, other_moves;
    sim::Keypad same{agenda, 1, [&] { same_moves.push_back(agenda.now_ps()); }};
    sim::Keypad other{agenda, 2, [&] { other_moves.push_back(agenda.now_ps()); }};
    for (sim::Keypad* k : {&keypad, &same, &other}) k->press(key(2, 2));
    settle();
    EXPECT_EQ(moves, same_moves);
    EXPECT_NE(moves, other_moves);
}

TEST_F(KeypadModel, EndsThePressesBounceAtARelease) {
    keypad.press(key(3, 3));
    pass(100 * US);
    keypad.release(key(3, 3));
    settle();
    EXPECT_EQ(rows(3), 0xfu);
}

}  // namespace
