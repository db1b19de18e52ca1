// board_pins.h - the chip's pins as the DE1-SoC's schematic names them, and as designs do.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace sim::project {

enum class Direction { INPUT, OUTPUT, INOUT };  // as the chip has it

struct BoardSignal {
    std::string_view name;  // "VGA_R"
    unsigned width;         // 8
    Direction direction;
    unsigned scalar;  // 1: written without an index
};

const std::vector<BoardSignal>& board_signals();

// The signal that a port of this name is meant to be: in any case, also as other boards of the
// family and courses write it (VGA_BLANK, I2C_SDAT, clk).
std::optional<BoardSignal> board_signal(std::string_view port);

// "PIN_AF14" -> "CLOCK_50", "PIN_AF9" -> "SW[3]"; from `pins`, the board's pins.tsv.
std::map<std::string, std::string> signals_by_pin(const std::filesystem::path& pins);

}  // namespace sim::project
