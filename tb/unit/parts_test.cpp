// parts_test.cpp - buttons, switches, LEDs and matrices on the wires of the headers
#include "sim/board/parts.h"

#include <gmock/gmock.h>

#include "sim/board/contact.h"
#include "sim/board/led_matrix.h"

namespace {

using sim::PinLevel;
using testing::ElementsAre;

constexpr std::uint64_t MS_PS = 1'000'000'000;

class Contacts : public ::testing::Test {
protected:
    sim::Header header;  // GPIO_0
    sim::Agenda agenda;
    const sim::PartSocket socket{
        agenda,
        [this](const sim::HeaderMasks& pins, PinLevel level) { header.part(pins[0], level); },
        [] {}};
};

TEST_F(Contacts, OfButtonsLeaveTheWireToThePullUp) {
    sim::Contact button{0, {PinLevel::RELEASED, PinLevel::LOW}, socket};
    EXPECT_EQ(header.driven(), 0u);
    button.close(true);
    EXPECT_EQ(header.levels() & 1, 0u);
    button.close(false);
    EXPECT_EQ(header.levels() & 1, 1u);
}

TEST_F(Contacts, OfSwitchesDriveBothLevelsAndBeginOpen) {
    sim::Contact slide{4, {PinLevel::LOW, PinLevel::HIGH}, socket};
    EXPECT_EQ(header.levels() >> 4 & 1, 0u);
    slide.close(true);
    EXPECT_EQ(header.levels() >> 4 & 1, 1u);
    EXPECT_EQ(header.driven(), 16u);
}

TEST_F(Contacts, AreFoundByNameAndKind) {
    sim::PartPlan plan;
    plan.name = "a";
    plan.hang = [](const sim::PartSocket& on) {
        return std::make_unique<sim::Contact>(0, sim::Contact::Levels{}, on);
    };
    sim::PartPlan keypad;
    keypad.name = "keypad";
    sim::Parts parts{{plan, keypad}, socket};
    parts.for_each<sim::Contact>([&parts](const std::string& name, sim::Contact& contact) {
        EXPECT_EQ(name, "a");
        EXPECT_EQ(&contact, &parts.get("a"));
    });
    parts.for_each<sim::LedMatrix>([](const std::string& name, auto&) { FAIL() << name; });
    EXPECT_THROW(parts.get("keypad"), std::out_of_range);
}

TEST(Led, IsLitByItsLevel) {
    sim::LedMatrix high{{{36}, {}, true}}, low{{{37}, {}, false}};
    high.look({0, 3}, 0);
    low.look({0, 3}, 0);
    EXPECT_TRUE(high.lit(MS_PS));
    EXPECT_FALSE(low.lit(MS_PS));
    high.look({0, 0}, 20 * MS_PS);
    low.look({0, 0}, 20 * MS_PS);
    EXPECT_FALSE(high.lit(21 * MS_PS));
    EXPECT_TRUE(low.lit(21 * MS_PS));
}

// Rows GPIO_0[1:0], active high; columns GPIO_1[2:0], active low.
class Matrix : public ::testing::Test {
protected:
    sim::LedMatrix matrix{{{1, 0}, {38, 37, 36}}};

    std::vector<std::string> shown(std::uint64_t at_ps) { return matrix.rows(at_ps); }
};

TEST_F(Matrix, ShowsAStillRowAtOnce) {
    matrix.look({2, 0b011}, 0);
    EXPECT_THAT(shown(50 * MS_PS), ElementsAre("#..", "..."));
}

TEST_F(Matrix, IsSeenWholeWhileItsRowsAreShownInTurn) {
    for (std::uint64_t t = 0; t < 100 * MS_PS; t += 4 * MS_PS) {
        matrix.look({2, 0b011}, t);
        matrix.look({1, 0b101}, t + 2 * MS_PS);
    }
    EXPECT_THAT(shown(100 * MS_PS), ElementsAre("#..", ".#."));
}

TEST_F(Matrix, HasDimLedsAndNoGhosts) {
    for (std::uint64_t t = 0; t < 100 * MS_PS; t += 4 * MS_PS) {
        matrix.look({2, 0b011}, t);
        matrix.look({2, 0b001}, t + 2 * MS_PS);  // the middle one for half a millisecond
        matrix.look({2, 0b111}, t + 5 * MS_PS / 2);
        matrix.look({1, 0b110}, t + 3 * MS_PS);  // and a ghost for 1/16 of the first row's time
        matrix.look({1, 0b111}, t + 3 * MS_PS + MS_PS / 8);
    }
    EXPECT_THAT(shown(100 * MS_PS), ElementsAre("#+.", "..."));
}

TEST_F(Matrix, IsDarkWithoutARow) {
    matrix.look({0, 0}, 0);
    EXPECT_THAT(shown(MS_PS), ElementsAre("...", "..."));
}

// The row is the number on GPIO_0[7,2]; columns GPIO_1[1:0], active high.
TEST(CodedMatrix, ShowsTheRowOfThatNumber) {
    sim::LedMatrix matrix{{{7, 2}, {37, 36}, false, true, true}};
    for (std::uint64_t t = 0; t < 100 * MS_PS; t += 4 * MS_PS) {
        matrix.look({0, 0b10}, t);
        matrix.look({1 << 2, 0b01}, t + MS_PS);
        matrix.look({1 << 7, 0b11}, t + 2 * MS_PS);
        matrix.look({1 << 7 | 1 << 2, 0b00}, t + 3 * MS_PS);
    }
    EXPECT_THAT(matrix.rows(100 * MS_PS), ElementsAre("#.", ".#", "##", ".."));
}

}  // namespace
