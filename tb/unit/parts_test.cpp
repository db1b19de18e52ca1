// parts_test.cpp - buttons, switches, LEDs and matrices on the wires of the headers.
#include "sim/board/parts.h"

#include <gmock/gmock.h>

namespace {

using sim::PartPlan;
using sim::PinLevel;
using testing::ElementsAre;

constexpr std::uint64_t MS_PS = 1'000'000'000;
using Kind = PartPlan::Kind;

class PartsTest : public ::testing::Test {
protected:
    sim::Header header;  // GPIO_0
    sim::Agenda agenda;

    sim::Parts plugged(const std::vector<PartPlan>& plans) {
        return {
            plans, agenda,
            [this](const sim::HeaderMasks& pins, PinLevel level) { header.part(pins[0], level); },
            [] {}};
    }
};

TEST_F(PartsTest, ButtonsCloseToGroundOrTo3V3) {
    sim::Parts parts = plugged({{Kind::BUTTON, "a", {0}, {}}, {Kind::BUTTON, "b", {1}, {}, true}});
    EXPECT_EQ(header.levels() & 3, 1u);
    EXPECT_EQ(header.driven(), 2u) << "a is left to the pull-up";
    parts.close("a", true);
    parts.close("b", true);
    EXPECT_EQ(header.levels() & 3, 2u);
    parts.close("a", false);
    parts.close("b", false);
    EXPECT_EQ(header.levels() & 3, 1u);
}

TEST_F(PartsTest, SwitchesDriveBothLevelsAndBeginLow) {
    sim::Parts parts = plugged({{Kind::SWITCH, "s", {4}, {}}});
    EXPECT_EQ(header.levels() >> 4 & 1, 0u);
    parts.close("s", true);
    EXPECT_EQ(header.levels() >> 4 & 1, 1u);
    EXPECT_EQ(header.driven(), 16u);
}

TEST_F(PartsTest, LedsAreLitByTheirLevel) {
    sim::Parts parts = plugged({{Kind::LED, "high", {36}, {}, true}, {Kind::LED, "low", {37}, {}}});
    parts.look({0, 3}, 0);
    EXPECT_TRUE(parts.leds("high").lit(MS_PS));
    EXPECT_FALSE(parts.leds("low").lit(MS_PS));
    parts.look({0, 0}, 20 * MS_PS);
    EXPECT_FALSE(parts.leds("high").lit(21 * MS_PS));
    EXPECT_TRUE(parts.leds("low").lit(21 * MS_PS));
}

// Rows GPIO_0[1:0], active high; columns GPIO_1[2:0], active low.
class Matrix : public PartsTest {
protected:
    sim::Parts parts = plugged({{Kind::LED_MATRIX, "m", {1, 0}, {38, 37, 36}, true}});

    std::vector<std::string> shown(std::uint64_t at_ps) { return parts.leds("m").picture(at_ps); }
};

TEST_F(Matrix, ShowsAStillRowAtOnce) {
    parts.look({2, 0b011}, 0);
    EXPECT_THAT(shown(50 * MS_PS), ElementsAre("#..", "..."));
}

TEST_F(Matrix, IsSeenWholeWhileItsRowsAreShownInTurn) {
    for (std::uint64_t t = 0; t < 100 * MS_PS; t += 4 * MS_PS) {
        parts.look({2, 0b011}, t);
        parts.look({1, 0b101}, t + 2 * MS_PS);
    }
    EXPECT_THAT(shown(100 * MS_PS), ElementsAre("#..", ".#."));
}

TEST_F(Matrix, HasDimLedsAndNoGhosts) {
    for (std::uint64_t t = 0; t < 100 * MS_PS; t += 4 * MS_PS) {
        parts.look({2, 0b011}, t);
        parts.look({2, 0b001}, t + 2 * MS_PS);  // the middle one for half a millisecond
        parts.look({2, 0b111}, t + 5 * MS_PS / 2);
        parts.look({1, 0b110}, t + 3 * MS_PS);  // and a ghost for 1/16 of the first row's time
        parts.look({1, 0b111}, t + 3 * MS_PS + MS_PS / 8);
    }
    EXPECT_THAT(shown(100 * MS_PS), ElementsAre("#+.", "..."));
}

TEST_F(Matrix, IsDarkWithoutARow) {
    parts.look({0, 0}, 0);
    EXPECT_THAT(shown(MS_PS), ElementsAre("...", "..."));
}

// The row is the number on GPIO_0[7,2]; columns GPIO_1[1:0], active high.
TEST_F(PartsTest, MatrixShowsTheRowOfThatNumber) {
    PartPlan plan{Kind::LED_MATRIX, "m", {7, 2}, {37, 36}, false, true};
    plan.coded_rows = true;
    sim::Parts parts = plugged({plan});
    for (std::uint64_t t = 0; t < 100 * MS_PS; t += 4 * MS_PS) {
        parts.look({0, 0b10}, t);
        parts.look({1 << 2, 0b01}, t + MS_PS);
        parts.look({1 << 7, 0b11}, t + 2 * MS_PS);
        parts.look({1 << 7 | 1 << 2, 0b00}, t + 3 * MS_PS);
    }
    EXPECT_THAT(parts.leds("m").picture(100 * MS_PS), ElementsAre("#.", ".#", "##", ".."));
}

}  // namespace
