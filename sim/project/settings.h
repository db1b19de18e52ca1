// settings.h - Quartus' settings files: .qsf, .qip, and the Tcl that they `source`.
//
// They are Tcl.  Read are the assignments, which is all that Quartus writes itself:
//
//   set_global_assignment -name TOP_LEVEL_ENTITY pong
//   set_location_assignment PIN_AF14 -to CLOCK_50
//   set_global_assignment -library pll -name VERILOG_FILE [file join $::quartus(qip_path) "pll.v"]
//   set_parameter -name WIDTH 8
//
// with quotes, braces and continued lines; other commands are passed over.  An assignment with
// -remove takes back those of the same name, target and value that stand before it; one with
// -disable counts for nothing.
#pragma once

#include <filesystem>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace sim::project {

// What is wrong with a project, in a line: file, line, what, what was expected.
class ProjectError : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
    std::vector<std::string>
        notes;  // what was found out before, which may be the cause; a line each
};

struct Assignment {
    std::string name;   // TOP_LEVEL_ENTITY; LOCATION for set_location_assignment;
                        // PARAMETER, INSTANCE_PARAMETER for set_parameter
    std::string value;  // pong; PIN_AF14
    std::string to;     // SW[3], or empty; the parameter
    std::filesystem::path file;
    unsigned line;
    bool in_qip_folder;  // the value is a path from the .qip's folder on
};

// The .qsf that `place` is, belongs to or, as a folder, has; empty: a folder without one.
// ProjectError: there is nothing, or several.
std::filesystem::path settings_at(const std::filesystem::path& place);

// In the order of the files, with those that they `source` where they do so.  ProjectError if
// `file` cannot be read, or over 1,000 are sourced; one that is missing then is passed over.
std::vector<Assignment> read_settings(const std::filesystem::path& file);
// The same of the file's text.
std::vector<Assignment> settings_in(std::string_view text, const std::filesystem::path& file);

// The file's text.  ProjectError: it cannot be read, or is larger than 64 MB.
std::string text_of(const std::filesystem::path& file);

}  // namespace sim::project
