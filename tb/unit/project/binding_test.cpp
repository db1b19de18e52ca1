// Ports of designs and pins of the board.
#include "sim/project/binding.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace {

using namespace sim::project;
using sim::Direction;
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

std::vector<std::string> wires(const Binding& binding, std::size_t port = 0) {
    std::vector<std::string> all;
    for (const auto& bit : binding.ports.at(port).bits) all.push_back(bit.wire);
    return all;
}

BoardDescription board(const char* folder) {
    return read_board(std::string{REPOSITORY} + "/rtl/board/" + folder + "/board.tsv");
}
BoardDescription de1_soc() { return board("de1_soc"); }

TEST(Binding, IsByNameInAnyCase) {
    const auto b = bind({{"Sw", Direction::INPUT, 1, 0, true}}, {}, de1_soc());
    EXPECT_EQ(wires(b), (std::vector<std::string>{"SW[1]", "SW[0]"}));
}

TEST(Binding, IsByLocationBeforeTheName) {
    const auto b =
        bind({{"KEY", Direction::INPUT, 1, 0, true}, {"osc", Direction::INPUT, 0, 0, false}},
             {{"KEY[0]", "PIN_AC12"}, {"osc", "PIN_AF14"}}, de1_soc());
    EXPECT_EQ(wires(b), (std::vector<std::string>{"KEY[1]", "SW[1]"}));
    EXPECT_EQ(wires(b, 1), (std::vector<std::string>{"CLOCK_50"}));
}

TEST(Binding, OfReversedRangesIsByIndex) {
    const auto b = bind({{"HEX0", Direction::OUTPUT, 0, 6, true}}, {}, de1_soc());
    EXPECT_EQ(wires(b).front(), "HEX0[0]");
    EXPECT_EQ(wires(b).back(), "HEX0[6]");
    EXPECT_THAT(design_text(b, "top", ""), HasSubstr("assign HEX0[0] = de1sim_port_0[6];"));
}

TEST(Binding, OfNarrowAndWideColoursIsOfTheirUpperBits) {
    EXPECT_EQ(wires(bind({{"VGA_R", Direction::OUTPUT, 3, 0, true}}, {}, de1_soc())),
              (std::vector<std::string>{"VGA_R[7]", "VGA_R[6]", "VGA_R[5]", "VGA_R[4]"}));
    const auto ten = wires(bind({{"VGA_G", Direction::OUTPUT, 9, 0, true}}, {}, de1_soc()));
    EXPECT_EQ(ten.front(), "VGA_G[7]");
    EXPECT_EQ(ten[7], "VGA_G[0]");
    EXPECT_EQ(ten[8], "");
}

TEST(Binding, KnowsWhetherThereIsAPictureToSee) {
    EXPECT_TRUE(bind({{"VGA_R", Direction::OUTPUT, 7, 0, true}}, {}, de1_soc()).has_vga);
    EXPECT_FALSE(bind({{"LEDR", Direction::OUTPUT, 9, 0, true}}, {}, de1_soc()).has_vga);
}

TEST(Binding, ReportsWhatFitsNowhere) {
    const auto b = bind({{"LEDG", Direction::OUTPUT, 7, 0, true},
                         {"rst_n", Direction::INPUT, 0, 0, false},
                         {"HPS_DDR3_CK_P", Direction::OUTPUT, 0, 0, false}},
                        {}, {});
    EXPECT_THAT(b.notes, Contains("ports without a pin of the board: LEDG, rst_n (is 1)"));
    EXPECT_THAT(design_text(b, "top", ""), HasSubstr(".rst_n (1'b1)"));
}

TEST(Binding, OfAWideColourWithLocationsIsByThem) {
    const auto b = bind({{"VGA_R", Direction::OUTPUT, 9, 0, true}},
                        {{"VGA_R[0]", "PIN_A13"}, {"VGA_R[7]", "PIN_F13"}}, de1_soc());
    EXPECT_EQ(wires(b),
              (std::vector<std::string>{"", "", "VGA_R[7]", "VGA_R[6]", "VGA_R[5]", "VGA_R[4]",
                                        "VGA_R[3]", "VGA_R[2]", "VGA_R[1]", "VGA_R[0]"}));
    EXPECT_THAT(b.notes, ElementsAre("VGA_R: 2 of its 10 bits have no pin of the board"));
}

TEST(Binding, GivesAPinToTheOutputThatHasItsLocation) {
    const auto b =
        bind({{"LEDR", Direction::OUTPUT, 0, 0, true}, {"x", Direction::OUTPUT, 0, 0, false}},
             {{"x", "PIN_V16"}}, de1_soc());
    EXPECT_EQ(wires(b, 1).front(), "LEDR[0]");
    EXPECT_THAT(b.notes,
                Contains(HasSubstr("output LEDR is on LEDR[0], which another output drives")));
}

TEST(Binding, DrivesLampsDarkThatTheDesignHasNot) {
    const std::string text = design_text(bind({}, {}, de1_soc()), "top", "");
    EXPECT_THAT(text, HasSubstr("assign HEX5[6] = 1'b1;"));
    EXPECT_THAT(text, HasSubstr("assign LEDR[9] = 1'b0;"));
    EXPECT_THAT(text, HasSubstr("assign VGA_BLANK_N = 1'b1;"));
}

TEST(Binding, KnowsWhichHeaderPinsAreOutputs) {
    const auto b = bind({{"GPIO_1", Direction::OUTPUT, 35, 0, true}}, {}, de1_soc());
    EXPECT_EQ(b.header_outputs[1], (std::uint64_t{1} << 36) - 1);
    EXPECT_EQ(b.header_outputs[0], 0u);
}

}  // namespace
