// project_commands.h - `de1sim build` and `de1sim check`, and what `run --project` needs of them.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "sim/project/build.h"

namespace CLI {
class App;
}

namespace sim {

struct ProjectOptions {
    std::filesystem::path place;  // .qsf, .qpf or folder; or empty
    std::string top;
    std::string board;  // its name, or empty: what the project tells
    std::vector<std::string> macros;
    unsigned build_limit_s = 600;

    project::Request request() const;
};

// --top, --board, -D and --build-limit, to which CLI11 adds what it parses.
void add_project_options(CLI::App& command, ProjectOptions& options);

// What `de1sim check` prints: all, or of the Platform Designer systems the addresses, hps_0.h, or
// the nodes for a device tree.
enum class CheckPrints { ALL, MAP, HEADER, DEVICE_TREE };

// Both print to stdout, and return an exit code.  project::ProjectError.
int build_project(const ProjectOptions& options);
int check_project(const ProjectOptions& options, CheckPrints prints);

// With a line on stderr for each thing that takes time, unless `quiet`.  `on_board` is called once
// the board is known, before anything is compiled, and may throw.
project::Built build_with_progress(
    const ProjectOptions& options, bool trace, bool quiet,
    const std::function<void(const project::BoardDescription&)>& on_board = {});

}  // namespace sim
