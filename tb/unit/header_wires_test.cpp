// header_wires_test.cpp - the wires of the headers, joined, and driven by two at once.
#include "sim/board/header_wires.h"

#include <gmock/gmock.h>

namespace {

using sim::PinLevel;
using testing::ElementsAre;
using testing::IsEmpty;

constexpr std::uint64_t ALL = sim::ALL_HEADER_PINS;

class HeaderWires : public ::testing::Test {
protected:
    std::vector<std::string> log;
    std::uint8_t joined = 0;  // low together as soon as one is

    sim::HeaderWires wires{[this](std::uint8_t driven, std::uint8_t enable) {
                               const bool low = enable & ~driven & joined;
                               return static_cast<std::uint8_t>(driven & ~(low ? joined : 0));
                           },
                           {36 + 35, 0, 2, 16, 18, 9, 8, 36},
                           [this](const std::string& line) { log.push_back(line); }};
};

TEST_F(HeaderWires, AreJoinedWhereTheKeypadHangs) {
    joined = 0x81;  // D7 is GPIO_1[35], D0 is GPIO_1[0]
    EXPECT_THAT(wires.settle(), ElementsAre(0xfffffffff, 0xfffffffff, ALL));
    wires.fpga({{0, 0}, {1, 1}});
    EXPECT_THAT(wires.settle(), ElementsAre(0xffffffffe, 0x7fffffffe, ALL));
    joined = 0x41;  // and D6 is GPIO_0[0]
    EXPECT_THAT(wires.settle(), ElementsAre(0xffffffffe, 0xffffffffe, ALL));
    wires.fpga({{1, 1}, {1, 1}});
    wires.part({0, 0x800000000}, PinLevel::LOW);
    EXPECT_THAT(wires.settle(), ElementsAre(0xfffffffff, 0x7ffffffff, ALL));
}

TEST_F(HeaderWires, ReportOnceWhereTwoDisagree) {
    wires.fpga({{0, 4}, {0, 4}});
    wires.hand({0, 4}, PinLevel::HIGH);
    wires.settle();
    EXPECT_THAT(log, IsEmpty());
    wires.part({0, 4}, PinLevel::LOW);
    EXPECT_THAT(wires.settle(), ElementsAre(0xfffffffff, 0xffffffffb, ALL)) << "low is stronger";
    EXPECT_THAT(log, ElementsAre("GPIO_1[2] is driven high and low at once; on a board that may "
                                 "damage it"));
    wires.settle();
    wires.part({0, 4}, PinLevel::RELEASED);
    wires.settle();
    wires.part({1, 4}, PinLevel::LOW);
    wires.settle();
    EXPECT_EQ(log.size(), 1u);
}

}  // namespace
