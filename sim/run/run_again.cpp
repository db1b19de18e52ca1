// run_again.cpp - see run_again.h
#include "sim/run/run_again.h"

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include <fmt/format.h>

#include "sim/project/command.h"
#include "sim/report/messages.h"
#include "sim/report/whole_file.h"

namespace sim {

namespace {

constexpr unsigned LIMIT_S = 24 * 3600;
constexpr const char* FILES[] = {"waves.fst", "waves.bus.txt", "waves.calls.txt"};

std::string last_line(const std::string& text) {
    const std::size_t end = text.find_last_not_of('\n');
    if (end == std::string::npos) return "";
    const std::size_t begin = text.rfind('\n', end);
    return text.substr(begin == std::string::npos ? 0 : begin + 1, end - (begin + 1) + 1);
}

std::string picoseconds(std::uint64_t ps) { return to_string(SimTime{ps}); }

}  // namespace

void run_again(const RunOptions& options, RunReport& report,
               const std::function<bool()>& given_up) {
    const auto missed = std::find_if(report.expectations.begin(), report.expectations.end(),
                                     [](const Expectation& e) { return !e.met; });
    const bool expected = missed != report.expectations.end();
    const double time_s = expected ? missed->time_s : report.simulated_s;
    const auto to_ps = static_cast<std::uint64_t>(std::llround(time_s * 1e12));
    const std::uint64_t from_ps = to_ps - std::min(to_ps - 1, options.trace_failure->ps);

    const std::filesystem::path folder = options.out / "failure";
    make_folder(folder);
    for (const char* file : FILES) std::filesystem::remove(folder / file);
    if (!options.quiet)
        message(fmt::format("running again for waveforms of {} to {}", picoseconds(from_ps),
                            picoseconds(to_ps)));
    std::vector<std::string> words{std::filesystem::read_symlink("/proc/self/exe").string(),
                                   "run",
                                   "--again",
                                   folder.string(),
                                   "--trace-from",
                                   picoseconds(from_ps),
                                   "--trace-to",
                                   picoseconds(to_ps)};
    words.insert(words.end(), options.words.begin(), options.words.end());
    const project::Outcome outcome = project::run_command(words, ".", LIMIT_S, given_up);

    std::string found;
    for (const char* file : FILES)
        if (std::filesystem::exists(folder / file))
            found += (found.empty() ? "; see " : ", ") + (folder / file).string();
    if (found.empty()) found = "; no waveforms: " + last_line(outcome.output);
    if (expected)
        missed->detail += found;
    else if (!report.faults.empty())
        report.faults.front() += found;
    else
        report.advice.push_back("waveforms of the end" + found);
}

}  // namespace sim
