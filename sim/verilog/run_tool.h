// run_tool.h - Verilator, GHDL and the compiler, as a build runs them
#pragma once

#include <chrono>
#include <filesystem>
#include <string>
#include <vector>

#include "sim/process/run_command.h"

namespace sim::project {

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

// The first error of Verilator, GHDL or the compiler, in a line: "pong.v:12: Quartus error 10170:
// syntax error ...".
std::string error_of(const Outcome& outcome, const std::string& tool, const TimeLimit& limit);

// Runs it in `folder`, and returns what it says.  ProjectError with its first error in a line, if
// it fails, is missing, or does not end in time.
std::string run_tool(const std::vector<std::string>& words, const std::filesystem::path& folder,
                     const TimeLimit& limit);

// The name of a file for a `line directive, which Verilator reads up to a blank.  The messages
// of run_tool() have the blanks again.
std::string without_blanks(std::string name);
std::string with_blanks(std::string text);

}  // namespace sim::project
