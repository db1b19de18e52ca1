// scenario.h - what a scenario file says, as data
//
// The steps of the language are in steps/; scenario.schema.json, printed from their forms, lets an
// editor complete them.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "sim/board/part_plan.h"
#include "sim/board/ps2_ports.h"
#include "sim/board/usb_ports.h"
#include "sim/scenario/board_parts.h"
#include "sim/scenario/sim_time.h"
#include "sim/scenario/step.h"

namespace sim {

struct ScenarioStep {
    int line = 0;  // in the file, from 1
    int column = 0;
    std::string text;  // what step->describe() says
    std::unique_ptr<Step> step;
};

struct Scenario {
    std::string name;
    std::filesystem::path file;
    std::string text;  // of the file
    std::uint64_t seed = 1;
    std::optional<SimTime> duration;
    // Relative to the working directory, or absolute; or empty.
    std::filesystem::path program, project;
    std::string board_name;  // as --board, or empty
    int board_line = 0, board_column = 0;
    std::string cpu;                     // "native", "arm", or empty
    std::optional<bool> memory_bridged;  // as --fpga-memory says
    std::optional<unsigned> audio_rate;  // samples per second
    unsigned points = 1;                 // for who grades
    std::string visibility = "visible";  // of these, as Gradescope names it
    Ps2Ports ps2;
    UsbPlugs usb;
    BoardParts board;                 // as far as is known
    bool on_linux = true;             // what runs is a Linux program, as far as is known
    std::vector<PartPlan> parts;      // on the headers
    std::vector<ScenarioStep> steps;  // may be empty when there is a duration
};

// what() is one printable line, "file:line:column: expected ..., got ...".  Lines and columns (in
// bytes) count from 1; both are 0, and left out of what(), if the error concerns the whole file.
class ScenarioError : public std::runtime_error {
public:
    ScenarioError(std::filesystem::path file, int line, int column, std::string message);

    std::filesystem::path file;
    int line;
    int column;
    std::string message;
};

// Reads a file and checks all that can be known before the run, golden pictures included, which
// may be missing where the run writes them.
Scenario load_scenario(const std::filesystem::path& file, Goldens goldens = Goldens::ARE_THERE);

// The same for text that is already in memory.  `file` is for messages, and paths in the text are
// relative to its folder; nothing is opened.
Scenario parse_scenario(std::string_view text, const std::filesystem::path& file);

// Again what can be known before the run, now with `board` and `on_linux`;
// ScenarioError.
void check_scenario(const Scenario& scenario);

}  // namespace sim
