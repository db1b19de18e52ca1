// project.h - somebody's design for a board: its files, its top module, its pins.
//
// From a Quartus project (.qsf or .qpf) or from a folder of Verilog.  What Quartus finds by itself
// is found here too: modules in files that are not listed, by the name of the file; paths with
// backslashes, in another case, or absolute ones of another machine.
#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "sim/project/board_description.h"
#include "sim/project/qsys/generate.h"
#include "sim/project/settings.h"
#include "sim/verilog/top_parameters.h"

namespace sim::project {

struct SourceFile {
    enum class Language { VERILOG, SYSTEM_VERILOG, VHDL };
    std::filesystem::path path;
    Language language;
    bool listed;            // in the project, or found
    std::string library;    // where it is listed, unless that is "work"
    std::string text = {};  // instead of the file's: made of a Platform Designer system

    std::string whole_text() const;  // empty: it cannot be read
};

// Rounds: VERILOG_CONSTANT_LOOP_LIMIT and VERILOG_NON_CONSTANT_LOOP_LIMIT of the .qsf.
struct LoopLimits {
    unsigned constant = 5'000, non_constant = 250;
};

struct Project {
    std::filesystem::path folder;    // absolute
    std::filesystem::path settings;  // the .qsf, or empty
    BoardDescription board;
    std::string top;
    std::vector<SourceFile> sources;          // what the top needs, packages first
    std::vector<std::filesystem::path> vhdl;  // all files of it, if something needs one
    std::map<std::string, std::vector<std::filesystem::path>> vhdl_libraries;  // of -library
    std::vector<std::string> entities;  // that are the top, or that Verilog instances
    std::vector<std::filesystem::path> includes;
    std::vector<std::string> macros;  // NAME or NAME=VALUE
    TopParameters parameters;
    LoopLimits loop_limits;
    std::vector<qsys::Generated> systems;  // of Platform Designer
    std::string why_missing;  // the reason, where modules that the sources name are not there
    std::map<std::string, std::string> pins;              // "SW[3]" -> "PIN_AF9"
    std::map<std::string, std::string> places_of_pins;    // "SW[3]" -> "top.qsf:12"
    std::map<std::string, std::string> processor_places;  // "uart" -> HPS_LOCATION's site
    bool is_for_other_device = false;                     // so there are no pins
    std::vector<std::string> notes;                       // what a person should know, a line each
};

struct Request {
    std::filesystem::path place;      // .qsf, .qpf or folder
    std::string top;                  // instead of the project's, or empty
    std::string board;                // its name, or empty: what the project tells
    std::vector<std::string> macros;  // besides the project's
    unsigned build_limit_s = 600;
    // Modules that need no file, since there are models of them.
    std::function<bool(const std::string& module)> is_model = [](const std::string&) {
        return false;
    };
};

// ProjectError: nothing there, no top module or several, a part that cannot be simulated (the
// processor's Qsys system, Nios, a schematic, encrypted files).
Project read_project(const Request& request);

}  // namespace sim::project
