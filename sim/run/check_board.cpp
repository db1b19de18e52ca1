// check_board.cpp - see check_board.h
#include "sim/run/check_board.h"

#include <new>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "sim/files/whole_file.h"
#include "sim/report/compare.h"
#include "sim/run/options.h"
#include "sim/text/messages.h"

#include "check_board_scenario.h"

namespace sim {

namespace {

constexpr std::size_t MAX_REPORT_BYTES = 64u << 20;

}  // namespace

void add_check_board_options(CLI::App& command, RunDescription& run) {
    run.scenario = "check_board.yaml";
    run.scenario_text = CHECK_BOARD_SCENARIO;
    run.outputs.out = "out/check-board";
    run.outputs.frames = {FrameChoice::Which::LAST, 1};
    run.program.arguments = {"--self-test"};
    command
        .add_option("--out", run.outputs.out, "folder for report.json and the other files of a run")
        ->check(named)
        ->capture_default_str();
    command
        .add_option("--elf", run.program.elf,
                    "collide-linux, to run its --self-test on the modelled Cortex-A9")
        ->check(named);
    command.add_flag("--quiet", run.outputs.quiet,
                     "no progress, no summary unless something failed");
}

ExitCode compare_reports(const std::filesystem::path& a, const std::filesystem::path& b) try {
    const std::string first = read_whole_file(a, MAX_REPORT_BYTES);
    const std::string second = read_whole_file(b, MAX_REPORT_BYTES);
    const auto lines = differences(first, a.string(), second, b.string());
    std::string text;
    for (const std::string& line : lines) text += line + "\n";
    text += lines.empty() ? "the same checks with the same results\n"
                          : fmt::format("{} of the checks differ\n", lines.size());
    if (!print_result(text)) return WRONG_INPUT;
    return lines.empty() ? PASSED : FAILED;
} catch (const std::bad_alloc&) {
    complain("out of memory while comparing the reports");
    return WRONG_INPUT;
} catch (const std::exception& error) {
    complain(error.what());
    return WRONG_INPUT;
}

}  // namespace sim
