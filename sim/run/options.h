// options.h - the command line of `de1sim run`, from which a run's description is made.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "sim/run/description.h"

namespace CLI {
class App;
}

namespace sim {

// As typed.
struct RunOptions {
    std::filesystem::path file;              // a scenario, or a program; or empty
    std::filesystem::path description_file;  // instead of all others; or empty
    RunDescription description;
};

// A check for CLI11: what is wrong with the name of a file or folder, or nothing.
std::string named(const std::string& name);

// An option that is a time after 0.  CLI::ValidationError.
void add_time_option(CLI::App& command, const char* name, std::optional<SimTime>& time,
                     const char* help);

// Describes the options to CLI11, which fills `options` when it parses.
void add_run_options(CLI::App& command, RunOptions& options);

// What they mean together.  `needs_file`: there must be a scenario or a program.
// CLI::ValidationError: options that exclude each other, or a wrong value; std::runtime_error: a
// file that is neither scenario nor program, or no description.
RunDescription described_by(const CLI::App& command, const RunOptions& options, bool needs_file);

}  // namespace sim
