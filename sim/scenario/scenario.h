// scenario.h - what a scenario file says, as data
//
// step_table.cpp lists every step and field with its default; scenario.schema.json, printed from
// it, lets an editor complete them.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "sim/scenario/controls.h"
#include "sim/scenario/sim_time.h"

namespace sim {

struct Delay {
    SimTime time;
};
struct Press {  // holds for that time, then lets go; only then the next step
    Controls controls;
    SimTime time;
};
struct Hold {
    Controls controls;
};
struct Release {
    Controls controls;
};
struct TypeSerial {  // goes on to the next step at once
    std::string text;
};
struct TypeKeys {  // goes on to the next step at once
    std::string text;
};
struct SetVoltage {
    unsigned channel = 0;
    double volts = 0;
};
struct WaitFrame {
    enum class What { NUMBER, NEXT, NEXT_SWAP };
    What what = What::NEXT;
    std::uint64_t number = 0;  // for NUMBER: 1 is the first frame since power-on
    SimTime timeout;
};
struct WaitSerial {
    std::string text;
    SimTime timeout;
};
struct ExpectFrame {
    std::filesystem::path golden;  // relative to the working directory, or absolute
    std::uint64_t differing_pixels = 0;
};
struct ExpectTone {  // begins within `timeout` and lasts `time`
    double hz = 0;
    double within = 0;  // fraction: 0.03 for 3%
    SimTime time;
    SimTime timeout;
};
struct ExpectSilence {
    SimTime time;
};
struct ExpectLeds {
    std::uint16_t leds = 0;  // bit n = LEDRn
    SimTime timeout;         // 0 = now
};
struct ExpectHex {
    std::string text;  // six characters, HEX5 first
    SimTime timeout;
};
struct TakeScreenshot {
    std::filesystem::path save_to;  // relative to the output folder, and inside it
};

using Action = std::variant<Delay, Press, Hold, Release, TypeSerial, TypeKeys, SetVoltage,
                            WaitFrame, WaitSerial, ExpectFrame, ExpectTone, ExpectSilence,
                            ExpectLeds, ExpectHex, TakeScreenshot>;

struct Step {
    int line = 0;  // in the file, from 1
    int column = 0;
    std::string text;  // the step in one line, as a person would say it
    Action action;
};

struct Scenario {
    std::string name;
    std::filesystem::path file;
    std::uint64_t seed = 1;
    std::optional<SimTime> duration;
    std::filesystem::path program;  // ELF, relative to the working directory, or absolute; or empty
    std::vector<Step> steps;        // may be empty when there is a duration
};

// what() is one printable line, "file:line:column: expected ..., got ...".  Line and column count
// from 1, columns in bytes; both are 0, and left out of what(), when the whole file is meant.
class ScenarioError : public std::runtime_error {
public:
    ScenarioError(std::filesystem::path file, int line, int column, std::string message);

    std::filesystem::path file;
    int line;
    int column;
    std::string message;
};

// Reads a file and checks all that can be known before the run, golden pictures included.
Scenario load_scenario(const std::filesystem::path& file);

// The same for text that is already in memory.  `file` is for messages, and paths in the text are
// relative to its folder; nothing is opened.
Scenario parse_scenario(std::string_view text, const std::filesystem::path& file);

// One line as a person would say it: "press keypad 5 for 80ms".
std::string say(const Action& action);

}  // namespace sim
