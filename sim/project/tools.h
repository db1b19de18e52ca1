// tools.h - Verilator and the compiler, and the files that de1sim brings for them.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace sim::project {

// `share` of an installation, or of the build tree.
std::filesystem::path data_folder();

// The name of a file for a `line directive, which Verilator reads up to a blank.  The messages
// of run_tool() have the blanks again.
std::string without_blanks(std::string name);

// Runs it in `folder`, and returns what it says.  ProjectError with its first error in a line, if
// it fails, is missing, or does not end in ten minutes.
std::string run_tool(const std::vector<std::string>& words, const std::filesystem::path& folder);

// ProjectError: there is no Verilator, or another than de1sim was built with; what it translates
// runs on the library of one version.
void check_verilator();

// Verilator's output in `objects`, with runtime/model.cpp: objects/chip.so.  `folder` has
// de1sim_clocks.h.  ProjectError.
void compile_library(const std::filesystem::path& folder, const std::filesystem::path& objects,
                     bool trace);

}  // namespace sim::project
