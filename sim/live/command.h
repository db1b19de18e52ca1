// command.h - `de1sim live`: its options, and what its simulations are.
#pragma once

#include <string>

#include "sim/report/exit_code.h"
#include "sim/run/options.h"

namespace sim::live {

struct LiveOptions {
    unsigned port = 0;
    std::string address = "127.0.0.1";
    bool driven = false;
    RunOptions run;  // those of `de1sim run`, too
};

void add_live_options(CLI::App& command, LiveOptions& options);

// As sim::described_by().
RunDescription described_by(const CLI::App& command, const LiveOptions& options);

// Serves until a signal.  std::runtime_error: the port is taken, there is no process.
ExitCode live(const LiveOptions& options, const RunDescription& run);

}  // namespace sim::live
