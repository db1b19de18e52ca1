// tools.h - Verilator and the compiler, and the files that de1sim brings for them.
#pragma once

#include <chrono>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace sim::project {

struct Verilator;

// `share` of an installation, or of the build tree.
std::filesystem::path data_folder();
// The model of a module of Intel's IP; nothing: there is none.
std::optional<std::filesystem::path> model_of(const std::string& module);

// A library of it.
std::filesystem::path library(const char* name);

// The name of a file for a `line directive, which Verilator reads up to a blank.  The messages
// of run_tool() have the blanks again.
std::string without_blanks(std::string name);
std::string with_blanks(std::string text);

// A symbolic link to a folder: a name without blanks, over which Verilator stumbles.
void link_to(const std::filesystem::path& folder, const std::filesystem::path& link);

// The name of another folder in `folder`: ".." or "../.." where it lies in the other one, else the
// link `link`.  A link to what `folder` lies in would be an endless path for a program that copies
// or searches it.
std::string seen_from(const std::filesystem::path& folder, const std::filesystem::path& other,
                      const std::string& link);

bool is_writable(const std::filesystem::path& folder);

// For all that a build runs, from when it is made on.
class TimeLimit {
public:
    explicit TimeLimit(unsigned seconds);
    unsigned seconds() const { return seconds_; }
    unsigned left_s() const;  // 0: it has passed

private:
    unsigned seconds_;
    std::chrono::steady_clock::time_point end_;
};

// Runs it in `folder`, and returns what it says.  ProjectError with its first error in a line, if
// it fails, is missing, or does not end in time.
std::string run_tool(const std::vector<std::string>& words, const std::filesystem::path& folder,
                     const TimeLimit& limit);

// Verilator's output in `objects`, with runtime/design.cpp: objects/chip.so.  `folder` has
// de1sim_facts.h.  ProjectError.
void compile_library(const std::filesystem::path& folder, const std::filesystem::path& objects,
                     bool trace, const Verilator& verilator, const TimeLimit& limit);

}  // namespace sim::project
