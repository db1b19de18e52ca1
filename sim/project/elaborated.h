// elaborated.h - what Verilator knows of a design: the top's ports, and the PLLs' clocks.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "sim/project/board_pins.h"
#include "sim/project/pin_clocks.h"

namespace sim::project {

struct Port {
    std::string name;
    Direction direction;
    int left, right;  // [7:0] is 7 and 0; a scalar's are 0
    bool vector;      // has a range
};

// One output of a PLL, in femtoseconds.
struct PllClock {
    std::uint64_t period_fs, phase_fs, high_fs;
    bool is_settable;  // the design can change it
    // The top's outputs that it drives and nothing else in the design sees; else empty.
    std::vector<PinClocks::PortBit> pins;
    bool operator==(const PllClock& o) const {
        return period_fs == o.period_fs && phase_fs == o.phase_fs && high_fs == o.high_fs &&
               is_settable == o.is_settable;
    }
};

// A file that a model of IP begins with: INIT_FILE or LPM_FILE.
struct InitFile {
    std::string name;   // as written
    std::string place;  // of the instance: "rom.v:12"
};

struct Elaborated {
    std::vector<Port> ports;
    std::vector<PllClock> pll_clocks;  // each once
    std::vector<InitFile> init_files;
};

// From Verilator's file, as syntax_tree() has it.  ProjectError.
Elaborated read_elaborated(const std::filesystem::path& file, const std::string& top);

// The parameters' values of each copy of a module, as Verilator prints them: 32'sh8, "text".
std::vector<std::map<std::string, std::string>> parameters_of(const std::filesystem::path& file,
                                                              const std::string& module);

}  // namespace sim::project
