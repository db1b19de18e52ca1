#include "sim/run/run_again.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "sim/files/whole_file.h"
#include "sim/process/run_command.h"
#include "sim/text/messages.h"

namespace sim {

namespace {

constexpr unsigned LIMIT_S = 24 * 3600;
constexpr const char* FILES[] = {"waves.fst", "waves.bus.txt", "waves.calls.txt"};

}  // namespace

std::string run_part_again(const RunDescription& run, const RunPart& part,
                           const std::function<bool()>& given_up) {
    make_folder(part.folder);
    for (const char* file : FILES) std::filesystem::remove(part.folder / file);
    RunDescription again = run;
    if (!part.scenario.empty()) again.scenario = part.scenario;
    again.outputs = {};
    again.outputs.out = part.folder;
    again.outputs.trace = {(part.folder / FILES[0]).string(), part.from, part.to};
    again.outputs.frames = {FrameChoice::Which::NONE, 1};
    again.outputs.quiet = true;
    again.duration = part.to;
    const DescriptionFile description{again};
    const std::vector<std::string> command = description.command();
    const Outcome outcome = run_command(command, ".", LIMIT_S, given_up);
    if (std::filesystem::exists(part.folder / FILES[0])) return "";
    const std::string line = outcome.last_line();
    return line.empty() ? fmt::format("exit code {}", outcome.code) : line;
}

void trace_failure(const RunDescription& run, RunReport& report,
                   const std::function<bool()>& given_up) {
    const auto missed = std::find_if(report.expectations.begin(), report.expectations.end(),
                                     [](const Expectation& e) { return !e.met; });
    const bool expected = missed != report.expectations.end();
    const double time_s = expected ? missed->time_s : report.simulated_s;
    const auto to_ps = static_cast<std::uint64_t>(std::llround(time_s * 1e12));
    const std::uint64_t from_ps = to_ps - std::min(to_ps - 1, run.outputs.trace_failure->ps);
    const RunPart part{run.outputs.out / "failure", SimTime{from_ps}, SimTime{to_ps}, {}};
    if (!run.outputs.quiet)
        message(fmt::format("running again for waveforms of {} to {}", to_string(part.from),
                            to_string(part.to)));
    const std::string problem = run_part_again(run, part, given_up);

    std::string found;
    for (const char* file : FILES)
        if (problem.empty() && std::filesystem::exists(part.folder / file))
            found += (found.empty() ? "; see " : ", ") + (part.folder / file).string();
    if (found.empty()) found = "; no waveforms: " + problem;
    if (expected)
        missed->detail += found;
    else if (!report.faults.empty())
        report.faults.front() += found;
    else
        report.advice.push_back("waveforms of the end" + found);
}

}  // namespace sim
