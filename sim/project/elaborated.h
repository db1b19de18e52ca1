// elaborated.h - what Verilator knows of a design: the top's ports, and the PLLs' clocks.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "sim/project/board_description.h"
#include "sim/project/clock_uses.h"

namespace sim::project {

struct Port {
    std::string name;
    Direction direction;
    int left, right;  // [7:0] is 7 and 0; a scalar's are 0
    bool vector;      // has a range
};

// One output of a PLL, or a clock of the processor's, in femtoseconds.
struct PllClock {
    std::uint64_t period_fs, phase_fs, high_fs;
    bool is_settable;                   // the design can change it
    std::set<std::string> names;        // of what makes it: PLL, h2f_user0_clk
    std::optional<ClockUses::Use> use;  // nothing: anything may see all of it
    bool operator==(const PllClock& o) const {
        return period_fs == o.period_fs && phase_fs == o.phase_fs && high_fs == o.high_fs &&
               is_settable == o.is_settable;
    }
};

// A file that a memory begins with: of a model by INIT_FILE or LPM_FILE, or of the design's own.
struct InitFile {
    std::string name;    // as written
    std::string place;   // of the instance or memory: "rom.v:12"
    std::string reader;  // $readmemh, $readmemb; else it is a MIF or Intel HEX file
};

struct Elaborated {
    std::vector<Port> ports;
    std::vector<PllClock> pll_clocks;                  // each once
    std::map<std::string, ClockUses::Use> input_uses;  // the top's inputs of which it is known
    std::vector<InitFile> init_files;
};

// From Verilator's file, as syntax_tree() has it.  ProjectError.
Elaborated read_elaborated(const std::filesystem::path& file, const std::string& top);

// The parameters' values of each copy of a module, as Verilator prints them: 32'sh8, "text".
std::vector<std::map<std::string, std::string>> parameters_of(const std::filesystem::path& file,
                                                              const std::string& module);

}  // namespace sim::project
