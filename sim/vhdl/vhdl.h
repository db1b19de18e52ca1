// vhdl.h - VHDL made into Verilog by GHDL, where that is installed; experimental.
#pragma once

#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "sim/verilog/run_tool.h"
#include "sim/vhdl/vhdl_files.h"
#include "sim/vhdl/vhdl_output.h"

namespace sim::project {

struct VhdlRoot {
    std::string entity, module;         // its name in Verilog
    std::vector<std::string> generics;  // -gWIDTH=8
};

struct VhdlDesign {
    std::filesystem::path folder;                  // names in messages are from here on
    std::vector<std::filesystem::path> files;      // all, in any order
    std::vector<VhdlRoot> roots;                   // what is wanted in Verilog
    std::set<std::filesystem::path> needed;        // another with an error is left out
    std::filesystem::path work;                    // for GHDL's libraries, emptied before
    std::map<std::string, std::string> libraries;  // text by name; what no file names is left out
    std::map<std::string, std::vector<std::filesystem::path>> own_libraries;  // files by name
    InVerilog in_verilog;
    InitialWordsAt initial_words;
};

// Verilog-2001 for each root, each module once.  ProjectError: GHDL is missing, or its first error.
std::vector<std::string> verilog_of(const VhdlDesign& design, const TimeLimit& limit);

}  // namespace sim::project
