#include "sim/project/board_pins.h"

#include <algorithm>
#include <sstream>

#include "sim/project/settings.h"
#include "sim/text/lower.h"

namespace sim::project {

const std::vector<BoardSignal>& board_signals() {
    using D = Direction;
    static const std::vector<BoardSignal> signals{{"CLOCK_50", 1, D::INPUT, 1},
                                                  {"CLOCK2_50", 1, D::INPUT, 1},
                                                  {"CLOCK3_50", 1, D::INPUT, 1},
                                                  {"CLOCK4_50", 1, D::INPUT, 1},
                                                  {"KEY", 4, D::INPUT, 0},
                                                  {"SW", 10, D::INPUT, 0},
                                                  {"LEDR", 10, D::OUTPUT, 0},
                                                  {"HEX0", 7, D::OUTPUT, 0},
                                                  {"HEX1", 7, D::OUTPUT, 0},
                                                  {"HEX2", 7, D::OUTPUT, 0},
                                                  {"HEX3", 7, D::OUTPUT, 0},
                                                  {"HEX4", 7, D::OUTPUT, 0},
                                                  {"HEX5", 7, D::OUTPUT, 0},
                                                  {"GPIO_0", 36, D::INOUT, 0},
                                                  {"GPIO_1", 36, D::INOUT, 0},
                                                  {"VGA_CLK", 1, D::OUTPUT, 1},
                                                  {"VGA_HS", 1, D::OUTPUT, 1},
                                                  {"VGA_VS", 1, D::OUTPUT, 1},
                                                  {"VGA_BLANK_N", 1, D::OUTPUT, 1},
                                                  {"VGA_SYNC_N", 1, D::OUTPUT, 1},
                                                  {"VGA_R", 8, D::OUTPUT, 0},
                                                  {"VGA_G", 8, D::OUTPUT, 0},
                                                  {"VGA_B", 8, D::OUTPUT, 0},
                                                  {"DRAM_CLK", 1, D::OUTPUT, 1},
                                                  {"DRAM_CKE", 1, D::OUTPUT, 1},
                                                  {"DRAM_CS_N", 1, D::OUTPUT, 1},
                                                  {"DRAM_RAS_N", 1, D::OUTPUT, 1},
                                                  {"DRAM_CAS_N", 1, D::OUTPUT, 1},
                                                  {"DRAM_WE_N", 1, D::OUTPUT, 1},
                                                  {"DRAM_BA", 2, D::OUTPUT, 0},
                                                  {"DRAM_ADDR", 13, D::OUTPUT, 0},
                                                  {"DRAM_LDQM", 1, D::OUTPUT, 1},
                                                  {"DRAM_UDQM", 1, D::OUTPUT, 1},
                                                  {"DRAM_DQ", 16, D::INOUT, 0},
                                                  {"AUD_XCK", 1, D::OUTPUT, 1},
                                                  {"AUD_BCLK", 1, D::INOUT, 1},
                                                  {"AUD_DACLRCK", 1, D::INOUT, 1},
                                                  {"AUD_DACDAT", 1, D::OUTPUT, 1},
                                                  {"AUD_ADCLRCK", 1, D::INOUT, 1},
                                                  {"AUD_ADCDAT", 1, D::INPUT, 1},
                                                  {"FPGA_I2C_SCLK", 1, D::OUTPUT, 1},
                                                  {"FPGA_I2C_SDAT", 1, D::INOUT, 1},
                                                  {"ADC_CS_N", 1, D::OUTPUT, 1},
                                                  {"ADC_SCLK", 1, D::OUTPUT, 1},
                                                  {"ADC_DIN", 1, D::OUTPUT, 1},
                                                  {"ADC_DOUT", 1, D::INPUT, 1},
                                                  {"PS2_CLK", 1, D::INOUT, 1},
                                                  {"PS2_DAT", 1, D::INOUT, 1},
                                                  {"PS2_CLK2", 1, D::INOUT, 1},
                                                  {"PS2_DAT2", 1, D::INOUT, 1},
                                                  {"IRDA_RXD", 1, D::INPUT, 1},
                                                  {"IRDA_TXD", 1, D::OUTPUT, 1},
                                                  {"TD_CLK27", 1, D::INPUT, 1},
                                                  {"TD_DATA", 8, D::INPUT, 0},
                                                  {"TD_HS", 1, D::INPUT, 1},
                                                  {"TD_VS", 1, D::INPUT, 1},
                                                  {"TD_RESET_N", 1, D::OUTPUT, 1},
                                                  {"FAN_CTRL", 1, D::OUTPUT, 1}};
    return signals;
}

std::optional<BoardSignal> board_signal(std::string_view port) {
    // DE1, DE2, DE2-115 and the habits of courses.
    static const std::map<std::string, std::string_view, std::less<>> OTHERWISE{
        {"clk", "CLOCK_50"},
        {"clock", "CLOCK_50"},
        {"clk_50", "CLOCK_50"},
        {"clk50", "CLOCK_50"},
        {"clock50", "CLOCK_50"},
        {"clk_50mhz", "CLOCK_50"},
        {"clock_50mhz", "CLOCK_50"},
        {"fpga_clk1_50", "CLOCK_50"},
        {"keys", "KEY"},
        {"key_n", "KEY"},
        {"switches", "SW"},
        {"sws", "SW"},
        {"led", "LEDR"},
        {"leds", "LEDR"},
        {"ledrs", "LEDR"},
        {"gpio0", "GPIO_0"},
        {"gpio1", "GPIO_1"},
        {"gpio_0_d", "GPIO_0"},
        {"gpio_1_d", "GPIO_1"},
        {"vga_blank", "VGA_BLANK_N"},
        {"vga_sync", "VGA_SYNC_N"},
        {"vga_hsync", "VGA_HS"},
        {"vga_vsync", "VGA_VS"},
        {"hsync", "VGA_HS"},
        {"vsync", "VGA_VS"},
        {"vga_red", "VGA_R"},
        {"vga_green", "VGA_G"},
        {"vga_blue", "VGA_B"},
        {"vga_clock", "VGA_CLK"},
        {"i2c_sclk", "FPGA_I2C_SCLK"},
        {"i2c_sdat", "FPGA_I2C_SDAT"},
        {"fpga_i2c_scl", "FPGA_I2C_SCLK"},
        {"fpga_i2c_sda", "FPGA_I2C_SDAT"},
        {"ps2_data", "PS2_DAT"},
        {"ps2_clock", "PS2_CLK"},
        {"ps2clk", "PS2_CLK"},
        {"ps2dat", "PS2_DAT"},
        {"ps2_kbclk", "PS2_CLK"},
        {"ps2_kbdat", "PS2_DAT"},
        {"ps2_msclk", "PS2_CLK2"},
        {"ps2_msdat", "PS2_DAT2"},
        {"adc_convst", "ADC_CS_N"},
        {"adc_sck", "ADC_SCLK"},
        {"adc_sdi", "ADC_DIN"},
        {"adc_sdo", "ADC_DOUT"},
        {"td_reset", "TD_RESET_N"}};
    const std::string name = lower(std::string{port});
    const auto otherwise = OTHERWISE.find(name);
    for (const BoardSignal& signal : board_signals())
        if (otherwise != OTHERWISE.end() ? signal.name == otherwise->second
                                         : lower(std::string{signal.name}) == name)
            return signal;
    return {};
}

std::map<std::string, std::string> signals_by_pin(const std::filesystem::path& pins) {
    std::map<std::string, std::string> signals;
    std::istringstream lines{text_of(pins)};
    for (std::string line; std::getline(lines, line);) {
        const std::size_t tab = line.find('\t');
        if (line.empty() || line[0] == '#' || tab == std::string::npos) continue;
        signals[line.substr(tab + 1)] = line.substr(0, tab);
    }
    return signals;
}

}  // namespace sim::project
