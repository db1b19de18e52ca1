// settings.h - Quartus' settings files: .qsf, .qip, .sdc, and the Tcl that they `source`.
//
// They are Tcl, and are run as such, by Debian's libtcl in a safe interpreter: variables, loops,
// procedures, `file join`.  Of Quartus' own commands those that assign are taken:
//
//   set_global_assignment -name TOP_LEVEL_ENTITY pong
//   set_location_assignment PIN_AF14 -to CLOCK_50          SW[3] is a word, and no command 3
//   set_global_assignment -library pll -name VERILOG_FILE [file join $::quartus(qip_path) "pll.v"]
//   set_parameter -name WIDTH 8
//
// Other commands give nothing, and a note says so where they are none of Quartus'.  An assignment
// with -remove takes back those of the same name, target and value that stand before it; one with
// -disable counts for nothing.
//
// The script can read no file but by `source`, run no program, and open no connection; it ends
// after 1,000,000 commands or 2 s.
//
// Not handled: a limit for the memory that a script takes.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "sim/verilog/project_error.h"

namespace sim::project {

struct Assignment {
    std::string name;     // TOP_LEVEL_ENTITY; LOCATION for set_location_assignment;
                          // PARAMETER, INSTANCE_PARAMETER for set_parameter
    std::string value;    // pong; PIN_AF14
    std::string to;       // SW[3], or empty; the parameter
    std::string library;  // of VHDL, or empty
    std::filesystem::path file;
    unsigned line;
    bool in_qip_folder;  // the value is a path from the .qip's folder on
};

// The .qsf that `place` is, belongs to or, as a folder, has, or the .tcl that makes a project;
// empty: a folder without one.
// ProjectError: there is nothing, or several.
std::filesystem::path settings_at(const std::filesystem::path& place);

struct Settings {
    std::vector<Assignment> assignments;  // in the order in which they are made
    std::vector<std::string> notes;       // "p.qsf:3: ..."
};

// ProjectError if `file` cannot be read, a line is wrong Tcl, the script does not end, or over
// 1,000 files are sourced.  One that is missing then is passed over.
Settings read_settings(const std::filesystem::path& file);
// The same of the file's text.
Settings settings_in(std::string_view text, const std::filesystem::path& file);

}  // namespace sim::project
