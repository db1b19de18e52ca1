// source.h - what a Verilog file defines and what it wants, found without elaborating it.
//
// Both branches of an `ifdef count, so it may want more than it does in the end.
#pragma once

#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace sim::project {

struct ModuleText {
    std::string name;
    unsigned line;
    std::set<std::string> wants = {};     // modules that it instances
    std::vector<std::string> ports = {};  // names, as far as they are declared
    bool is_package = false;
    std::vector<std::string> header = {};  // ports in the order of positional connections
    std::set<std::string> outputs = {}, inouts = {};   // of the ports
    std::vector<std::string> parameters = {};          // names
    std::map<std::string, std::string> defaults = {};  // of parameters, as written
    std::map<std::string, std::string> ranges = {};    // of ports, as written: "7 : 0"
    bool in_library = false;  // of a Platform Designer system or another library
};

struct SourceText {
    std::vector<ModuleText> modules;  // and packages
    std::set<std::string> packages;   // that it uses
};

SourceText scan(std::string_view text);

}  // namespace sim::project
