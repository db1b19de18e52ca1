// board_description.h - a board as its file rtl/board/NAME/board.tsv describes it: chip, signals.
//
// The simulated chip has wires (sim/pins/chip_wires.def), with the DE1-SoC's names.  A signal of a
// board is some of these wires, a clock, or nothing that is simulated.  What none of a board's
// signals is, the board has not.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "sim/pins/chip_wires.h"

namespace sim::project {

struct BoardSignal {
    std::string name;  // "HDMI_TX_D", as the board's schematic has it
    Direction direction;
    std::vector<std::string> wires;  // of the chip, bit 0 first; "": not simulated
    std::vector<std::string> pins;   // "PIN_AD12", likewise
    std::set<std::string> others;    // names that designs use, in small letters
    std::uint64_t period_fs = 0;     // of a clock that is none of the chip's wires, else 0

    unsigned width() const { return static_cast<unsigned>(pins.size()); }
    std::string bit(unsigned index) const;  // "HDMI_TX_D[3]"
};

struct BoardDescription {
    std::string name;                  // "DE10-Lite"
    std::vector<std::string> devices;  // "10M50DAF484", of which only the beginning counts
    unsigned long long registers = 0, memory_bits = 0;  // of the FPGA; 0: not known
    std::string memory_blocks;                          // "182 M9K"
    bool has_processor = false;
    unsigned analog_inputs = 0;  // of a converter in the FPGA
    bool has_lcd = false;        // on pins of the processor
    // That programs without a project run on: "DE1-SoC" or "DE10-Lite"; empty: none.
    std::string computer;
    std::set<std::string> on_i2c;      // parts on FPGA_I2C: "WM8731", "ADV7180", "ADV7513"
    std::set<std::string> other_pins;  // of the FPGA, where the board has nothing; empty: not known
    std::vector<BoardSignal> signals;

    // The signal that a port of this name is meant to be: in any case, or by another name.  Null:
    // none.
    const BoardSignal* signal(std::string_view port) const;
    // Of "SW[3]" or "VGA_HS".  Null: none.
    const BoardSignal* signal_of_bit(const std::string& bit) const;
    std::string wire_of_bit(const std::string& bit) const;      // "": not simulated
    std::map<std::string, std::string> signals_by_pin() const;  // "PIN_AF9" -> "SW[3]"

    bool has_device(const std::string& device) const;
    // Whether a signal of it is one of these wires: "PS2_CLK", "KEY[3]", "HEX0[0]".
    bool has_wire(const std::string& wire) const;
    // How many wires of that name, "KEY", it has.
    unsigned wires_named(std::string_view wanted) const;
};

// ProjectError, with the line: it is no such file.
BoardDescription read_board(const std::filesystem::path& file);

// The DE1-SoC, whose description is in the program: needs no file.
BoardDescription de1_soc();

// All that are described, by name.
std::vector<BoardDescription> all_boards();

// The one of that name, "DE10-Lite" or "de10_lite".  ProjectError: there is none.
BoardDescription board_named(const std::vector<BoardDescription>& boards, const std::string& name);

struct BoardRequest {
    std::string name;                         // by --board, or empty
    std::string device;                       // the project's, or empty
    std::map<std::string, std::string> pins;  // "SW[3]" -> "PIN_AF9"
};

struct BoardChoice {
    BoardDescription board;
    bool is_for_other_device;  // so its pins mean nothing
    std::vector<std::string> notes;
};

// The board that is named; else the one with that device or, where several boards have it or none,
// the one whose pins most of the assigned ones are; else the DE1-SoC.  ProjectError: there is none
// of that name, or several are possible.
BoardChoice choose_board(const std::vector<BoardDescription>& boards, const BoardRequest& request);

}  // namespace sim::project
