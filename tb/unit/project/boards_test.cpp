// Boards as files: what they say, which is chosen, and how its signals become the chip's wires.
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "sim/project/binding.h"
#include "sim/project/settings.h"
#include "tb/support/temp_folder.h"

namespace {

using namespace sim::project;
using sim::Direction;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

BoardDescription of(const char* folder) {
    return read_board(std::string{REPOSITORY} + "/rtl/board/" + folder + "/board.tsv");
}

std::vector<BoardDescription> all() {
    return {of("de1_soc"), of("de10_lite"), of("de10_nano"), of("de10_standard")};
}

std::string refusal(const std::string& text) {
    const TempFolder folder;
    folder.put("board.tsv", text);
    try {
        read_board(folder / "board.tsv");
    } catch (const ProjectError& error) {
        return error.what();
    }
    return "read";
}

std::string chosen(const BoardRequest& request) { return choose_board(all(), request).board.name; }

// User manuals: DE10-Lite 3.3 to 3.5, DE10-Standard 3.5, DE10-Nano 3.6.
TEST(Boards, HaveThePinsOfTheirManuals) {
    EXPECT_EQ(of("de10_lite").signals_by_pin().at("PIN_P11"), "MAX10_CLK1_50");
    EXPECT_EQ(of("de10_lite").signals_by_pin().at("PIN_D15"), "HEX0[7]");
    EXPECT_EQ(of("de10_standard").signals_by_pin().at("PIN_AK4"), "KEY[1]");
    EXPECT_EQ(of("de10_nano").signals_by_pin().at("PIN_AE26"), "LED[5]");
}

TEST(Boards, HaveAWireForEachSignalThatIsSimulated) {
    EXPECT_EQ(of("de10_lite").wire_of_bit("VGA_R[0]"), "VGA_R[4]");
    EXPECT_EQ(of("de10_lite").wire_of_bit("HEX3[7]"), "HEX3[7]");
    EXPECT_EQ(of("de10_lite").wire_of_bit("GSENSOR_INT[2]"), "");
    EXPECT_EQ(of("de10_nano").wire_of_bit("HDMI_TX_D[23]"), "VGA_R[7]");
    EXPECT_EQ(of("de10_nano").wire_of_bit("HDMI_TX_D[8]"), "VGA_G[0]");
    EXPECT_EQ(of("de10_nano").wires_named("KEY"), 2u);
    EXPECT_FALSE(of("de10_nano").has_wire("HEX0[0]"));
}

TEST(Boards, HaveTheDe1SocInTheProgramAsItsFileIs) {
    const auto own = de1_soc(), read = of("de1_soc");
    EXPECT_EQ(own.name, read.name);
    EXPECT_EQ(own.on_i2c, read.on_i2c);
    EXPECT_EQ(own.signals_by_pin(), read.signals_by_pin());
}

TEST(Boards, RefuseAFileWithItsLine) {
    const std::string head = "board\tB\ndevice\tD\n";
    EXPECT_THAT(refusal("board\tB\n"), HasSubstr("expected a line \"device\", got none"));
    EXPECT_THAT(refusal(head + "LED\tLAMP\tA1\n"),
                HasSubstr(":3: expected wires of chip_wires.def, a clock as \"10 MHz\", or -, got "
                          "\"LAMP\""));
    EXPECT_THAT(refusal(head + "KEY\tKEY\tA1 A2 A3 A4 A5\n"), HasSubstr("expected at most 4 pins"));
    EXPECT_THAT(refusal(head + "A\t-\tA1\nB\t-\tA1\n"), HasSubstr(":4: expected a pin of its own"));
    EXPECT_THAT(refusal(head + "memory\t9 M9K\n"), HasSubstr("got \"9 M9K\""));
    EXPECT_THAT(refusal(head + "CLK\t0 MHz\tA1\n"), HasSubstr("expected 1 to 1000 MHz"));
    EXPECT_THAT(refusal(head + "VGA_R\tVGA_R\t \n"), HasSubstr("expected the pins of VGA_R"));
}

TEST(Boards, AreChosenByTheDevice) {
    EXPECT_EQ(chosen({"", "10M50DAF484C7G", {}}), "DE10-Lite");
    EXPECT_EQ(chosen({"", "5CSEBA6U23I7DK", {}}), "DE10-Nano");
    EXPECT_EQ(chosen({"", "5csxfc6d6f31c6", {}}), "DE10-Standard");
    EXPECT_EQ(chosen({"", "", {}}), "DE1-SoC");
}

TEST(Boards, AreChosenByThePinsOfAnotherDevice) {
    const std::map<std::string, std::string> pins{
        {"FPGA_CLK1_50", "PIN_V11"}, {"LED[0]", "PIN_W15"}, {"KEY[1]", "PIN_AH16"}};
    EXPECT_EQ(chosen({"", "5CSEMA4U23C6", pins}), "DE10-Nano");
    EXPECT_EQ(chosen({"", "", pins}), "DE10-Nano");
    EXPECT_EQ(chosen({"", "10M50DAF484C7G", pins}), "DE10-Nano");
    EXPECT_EQ(chosen({"de10 lite", "5CSEBA6U23I7", pins}), "DE10-Lite");
}

TEST(Boards, ThatSeveralProjectsShareADeviceWithAreToldByThePins) {
    std::vector<BoardDescription> two{of("de10_lite"), of("de10_lite")};
    two[1].name = "Other";
    two[1].signals[0].pins = {"PIN_Z9"};
    EXPECT_EQ(choose_board(two, {"", "10M50DAF484C7G", {{"MAX10_CLK1_50", "PIN_Z9"}}}).board.name,
              "Other");
    EXPECT_THROW(choose_board(two, {"", "10M50DAF484C7G", {}}), ProjectError);
}

TEST(Boards, ThatAreNotThereAreRefusedWithTheList) {
    try {
        chosen({"DE9", "", {}});
        FAIL();
    } catch (const ProjectError& error) {
        EXPECT_STREQ(error.what(),
                     "board DE9: there is no such board: expected one of DE1-SoC (5CSEMA5F31C6), "
                     "DE10-Lite (10M50DAF484), DE10-Nano (5CSEBA6U23), DE10-Standard "
                     "(5CSXFC6D6F31)");
    }
}

TEST(Boards, ConnectAMonitorWithoutAClockOfItsOwn) {
    const auto lite = bind({{"VGA_R", Direction::OUTPUT, 3, 0, true}}, {}, of("de10_lite"));
    const std::string text = design_text(lite, "top", "");
    EXPECT_THAT(text, HasSubstr("assign VGA_R[7] = de1sim_port_0[3];"));
    EXPECT_THAT(text, HasSubstr("assign VGA_R[3] = VGA_R[7];"));
    EXPECT_THAT(text, HasSubstr("assign VGA_CLK = CLOCK_50;"));
    const auto nano = bind({{"HDMI_TX_D", Direction::OUTPUT, 23, 0, true}}, {}, of("de10_nano"));
    EXPECT_TRUE(nano.has_vga);
    EXPECT_TRUE(nano.connected.empty());
}

TEST(Boards, HaveClocksOfTheirOwn) {
    const auto b = bind({{"ADC_CLK_10", Direction::INPUT, 0, 0, false}}, {}, of("de10_lite"));
    EXPECT_EQ(b.clocks.count("ADC_CLK_10"), 1u);
    EXPECT_THAT(design_text(b, "top", ""), HasSubstr("wire ADC_CLK_10 = pll_clocks[0];"));
}

TEST(Boards, SaySoWhereNothingSimulatesAPort) {
    EXPECT_THAT(
        bind({{"ARDUINO_RESET_N", Direction::INOUT, 0, 0, false}}, {}, of("de10_lite")).notes,
        ElementsAre("ports on what the DE10-Lite has, but nothing simulates: ARDUINO_RESET_N"));
}

}  // namespace
