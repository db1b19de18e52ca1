#include "sim/live/command.h"

#include <algorithm>
#include <iterator>

#include <CLI/CLI.hpp>

#include "sim/live/server.h"
#include "sim/report/messages.h"
#include "sim/run/file_kind.h"

namespace sim::live {

namespace {

// Takes an option with its value out of the arguments.
void take_out(std::vector<std::string>& arguments, const std::string& option) {
    for (auto word = arguments.begin(); word != arguments.end() && *word != "--";) {
        if (*word == option)
            word =
                arguments.erase(word, std::next(word, std::next(word) == arguments.end() ? 1 : 2));
        else if (word->compare(0, option.size() + 1, option + "=") == 0)
            word = arguments.erase(word);
        else
            ++word;
    }
}

bool has(const std::vector<std::string>& arguments, const std::string& option) {
    for (const std::string& word : arguments)
        if (word == option || word.compare(0, option.size() + 1, option + "=") == 0) return true;
    return false;
}

}  // namespace

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

ExitCode live(const LiveOptions& options, std::vector<std::string> arguments) {
    ServerSettings settings;
    settings.address = options.address;
    settings.port = options.port;
    const auto& run = options.run;
    if (!run.scenario.empty()) refuse_other_kinds(run.scenario);
    if (!run.elf.empty()) refuse_no_program(run.elf);
    const auto& what = run.scenario.empty() ? run.elf : run.scenario;
    settings.title = !run.project.place.empty() ? run.project.place.filename().string()
                     : what.empty()             ? "the demo"
                                                : what.filename().string();
    for (const char* option : {"--port", "--listen", "--elf"}) take_out(arguments, option);
    arguments.erase(std::remove(arguments.begin(), arguments.end(), "--driven"), arguments.end());
    settings.driven = options.driven;
    // What runs comes first: what is dropped on the page takes its place.
    for (const auto& file : {run.scenario, run.elf}) {
        const auto word = std::find(arguments.begin(), arguments.end(), file.string());
        if (!file.empty() && word != arguments.end()) arguments.erase(word);
    }
    if (!run.scenario.empty()) settings.what = {run.scenario.string()};
    if (!run.elf.empty()) settings.what.insert(settings.what.end(), {"--elf", run.elf.string()});
    if (!has(arguments, "--frames")) settings.arguments = {"--frames", "none"};
    settings.arguments.push_back("--quiet");
    settings.arguments.insert(settings.arguments.end(), arguments.begin(), arguments.end());
    const int code = serve(settings, [](const std::string& url) {
        message("the board is at " + url);
        message("Ctrl-C ends it");
    });
    return code == WRONG_INPUT ? WRONG_INPUT : PASSED;  // its input or output was wrong
}

}  // namespace sim::live
