#include "sim/live/command.h"

#include <CLI/CLI.hpp>

#include "sim/live/server.h"
#include "sim/run/file_kind.h"
#include "sim/text/messages.h"

namespace sim::live {

void add_live_options(CLI::App& command, LiveOptions& options) {
    command.add_option("--port", options.port, "TCP port of the page; 0 takes a free one")
        ->check(CLI::Range(0, 65535))
        ->capture_default_str();
    command
        .add_option("--listen", options.address,
                    "address to listen at, instead of this machine alone; who knows the printed\n"
                    "address can play")
        ->capture_default_str();
    command.add_flag("--driven", options.driven,
                     "for a program that plays: time stands at 0 until it says \"run\", and all\n"
                     "ends with the last connection");
    add_run_options(command, options.run);
}

RunDescription described_by(const CLI::App& command, const LiveOptions& options) {
    RunDescription run = sim::described_by(command, options.run, false);
    if (!run.program.elf.empty()) refuse_no_program(run.program.elf);
    if (run.outputs.trace_failure)
        throw CLI::ValidationError("--trace-failure", "and live exclude each other");
    if (command.count("--frames") == 0) run.outputs.frames = {FrameChoice::Which::NONE, 1};
    run.outputs.quiet = true;
    return run;
}

ExitCode live(const LiveOptions& options, const RunDescription& run) {
    ServerSettings settings;
    settings.address = options.address;
    settings.port = options.port;
    settings.driven = options.driven;
    settings.run = run;
    const auto& project = run.chip.project.place;
    const auto& what = run.scenario.empty() ? run.program.elf : run.scenario;
    settings.title = !project.empty() ? project.filename().string()
                     : what.empty()   ? "the demo"
                                      : what.filename().string();
    const int code = serve(settings, [](const std::string& url) {
        message("the board is at " + url);
        message("Ctrl-C ends it");
    });
    return code == WRONG_INPUT ? WRONG_INPUT : PASSED;  // its input or output was wrong
}

}  // namespace sim::live
