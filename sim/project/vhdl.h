// vhdl.h - VHDL made into Verilog by GHDL, where that is installed; experimental.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "sim/project/source.h"
#include "sim/project/tools.h"

namespace sim::project {

// Entities, what they want (components, entities), and their ports, without analysing them.
SourceText scan_vhdl(std::string_view text);

struct VhdlDesign {
    std::filesystem::path folder;              // names in messages are from here on
    std::vector<std::filesystem::path> files;  // all, in any order
    std::vector<std::string> roots;            // entities that are wanted in Verilog
    std::filesystem::path work;                // for GHDL's libraries, emptied before
    std::filesystem::path libraries;           // NAME.vhd is the library NAME
    // The name in Verilog of a component that has no entity; empty: there is none.
    std::function<std::string(const std::string& component)> in_verilog;
};

// Verilog-2001 for each root, each module once.  ProjectError: GHDL is missing, or its first error.
std::vector<std::string> verilog_of(const VhdlDesign& design, const TimeLimit& limit);

}  // namespace sim::project
