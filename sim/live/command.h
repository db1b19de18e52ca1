// command.h - `de1sim live`: its options, and what of the command line is for the simulation.
#pragma once

#include <string>
#include <vector>

#include "sim/run/options.h"
#include "sim/run/run.h"

namespace sim::live {

struct LiveOptions {
    unsigned port = 0;
    std::string address = "127.0.0.1";
    bool driven = false;
    RunOptions run;  // those of `de1sim run`, too
};

void add_live_options(CLI::App& command, LiveOptions& options);

// `arguments` are those behind `live` on the command line, which CLI11 has found to be in order.
// std::runtime_error where the scenario or program is neither.
ExitCode live(const LiveOptions& options, std::vector<std::string> arguments);

}  // namespace sim::live
