// The chip's edge as Verilog, from the table of wires.
#include <string>

#include <gmock/gmock.h>

#include "sim/pins/chip_wires.h"
#include "sim/pins/header_pin.h"
#include "sim/project/chip_text.h"

namespace {

using sim::ChipPort;
using sim::ChipWire;
using sim::project::chip_ports_text;
using sim::project::chip_wires_text;
using testing::HasSubstr;
using testing::Not;

// Widths as in the DE1-SoC User Manual: ten switches, four keys, 36 pins of a header.
TEST(ChipText, HasThePortsOfTheTable) {
    const std::string text = chip_ports_text();
    EXPECT_THAT(text, HasSubstr("    input wire clock_50_i,\n"));
    EXPECT_THAT(text, HasSubstr("    input wire [3:0] key_ni,\n"));
    EXPECT_THAT(text, HasSubstr("    input wire [9:0] sw_i,\n"));
    EXPECT_THAT(text, HasSubstr("    output wire [35:0] gpio_1_oe_o,\n"));
    EXPECT_THAT(text, Not(HasSubstr(",\n\n")));
}

TEST(ChipText, TakesInputsOverWhenTheyHaveMoved) {
    const std::string text = chip_wires_text({});
    EXPECT_THAT(text, HasSubstr("    reg [3:0] KEY = {4{1'b1}};\n"));
    EXPECT_THAT(text, HasSubstr("        KEY <= key_ni;\n"));
    EXPECT_THAT(text, HasSubstr("        gpio_0_low <= gpio_0_low_i;\n"));
    EXPECT_THAT(text, HasSubstr("    wire [7:0] TD_DATA = td_data_i;\n"));
}

TEST(ChipText, DrivesWhatBothSidesMayDrive) {
    const std::string text = chip_wires_text({});
    EXPECT_THAT(text, HasSubstr("    assign GPIO_1[35] = gpio_1_low[35] ? 1'b0 : 1'bz;\n"));
    EXPECT_THAT(text, HasSubstr("    assign PS2_DAT2 = ps2_dat_low[1] ? 1'b0 : 1'bz;\n"));
    EXPECT_THAT(text, HasSubstr("    assign DRAM_DQ = dram_dq_en ? dram_dq : 16'bz;\n"));
    EXPECT_THAT(text, HasSubstr("    assign AUD_BCLK = aud_en ? aud[2] : 1'bz;\n"));
}

TEST(ChipText, PullsUpWhatHasAResistor) {
    const std::string text = chip_wires_text({});
    EXPECT_THAT(text, HasSubstr("pullup(FPGA_I2C_SDAT);"));
    EXPECT_THAT(text, HasSubstr("pullup(GPIO_0[17]);"));
    EXPECT_THAT(text, Not(HasSubstr("pullup(AUD_BCLK);")));
    EXPECT_THAT(text, Not(HasSubstr("pullup(DRAM_DQ[0]);")));
}

TEST(ChipText, ShowsWhatTheDesignDrives) {
    sim::HeaderMasks outputs{};
    sim::add(outputs, *sim::header_pin("GPIO_1[4]"));
    const std::string text = chip_wires_text(outputs);
    EXPECT_THAT(text, HasSubstr("assign gpio_0_oe_o = {36'd0 | ~GPIO_0 & ~gpio_0_low};"));
    EXPECT_THAT(text, HasSubstr("assign gpio_1_oe_o = {36'd16 | ~GPIO_1 & ~gpio_1_low};"));
    EXPECT_THAT(text, HasSubstr("assign clocks_o = {VGA_CLK,\n        DRAM_CLK,\n"
                                "        AUD_XCK};"));
    EXPECT_THAT(text, HasSubstr("~HEX5[7],\n"));
}

TEST(ChipWires, HaveAPlaceForEachBitOfAPort) {
    for (unsigned n = 0; n < std::size(sim::CHIP_PORTS); ++n) {
        const unsigned bits = sim::bits_of(static_cast<ChipPort>(n));
        EXPECT_TRUE(bits >= 1 && bits <= 64) << sim::CHIP_PORTS[n].name;
    }
    EXPECT_EQ(sim::lsb_of(ChipPort::vga_o, ChipWire::VGA_HS), 24u);
    EXPECT_EQ(sim::lsb_of(ChipPort::vga_o, "LEDR"), sim::NO_BIT);
}

TEST(ChipWires, HaveTheNamesOfPins) {
    EXPECT_EQ(sim::pin_name(*sim::header_pin("GPIO_1[35]")), "GPIO_1[35]");
    EXPECT_EQ(sim::pin_name(*sim::header_pin("ARDUINO_IO[15]")), "ARDUINO_IO[15]");
    EXPECT_FALSE(sim::header_pin("LEDR[3]"));
}

}  // namespace
