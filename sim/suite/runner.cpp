#include "sim/suite/runner.h"

#include <atomic>
#include <chrono>
#include <exception>
#include <mutex>
#include <sstream>
#include <thread>

#include <fmt/format.h>

#include "sim/process/run_command.h"
#include "sim/run/description.h"

namespace sim::suite {

namespace {

// A long text's end, from the beginning of a line on.
std::string last_lines(const std::string& text) {
    constexpr std::size_t MOST = 2'000;
    if (text.size() <= MOST) return text;
    const std::size_t line = text.find('\n', text.size() - MOST);
    return text.substr(line == std::string::npos ? text.size() - MOST : line + 1);
}

// The first line that names an error, else the first.
std::string first_error(const std::string& text) {
    std::istringstream lines{text};
    std::string first;
    for (std::string line; std::getline(lines, line);) {
        if (line.find("rror") != std::string::npos) return line;
        if (first.empty()) first = line;
    }
    return first;
}

Result run_case(const Case& one, const RunSettings& settings,
                const std::function<bool()>& given_up) {
    const std::string folder = "runs/" + one.name;
    const std::filesystem::path out = settings.out / folder;
    RunDescription run;
    run.scenario = one.file;
    run.program.elf = one.program;
    run.chip.project.place = one.project;
    run.outputs.out = out;
    run.outputs.frames = {FrameChoice::Which::NONE, 1};
    run.outputs.trace_failure = settings.trace_failure;
    run.outputs.update_goldens = settings.update_goldens;
    run.outputs.quiet = true;
    const DescriptionFile description{run};
    const std::vector<std::string> command = description.command();
    // What an earlier run has left must not stand for this one.
    for (const char* file : {"report.json", "junit.xml"}) {
        std::error_code error;
        std::filesystem::remove(out / file, error);
    }
    const auto begin = std::chrono::steady_clock::now();
    HandIns* const hand_ins = one.hand_in.empty() ? nullptr : settings.hand_ins;
    std::string not_built;
    if (hand_ins) not_built = hand_ins->prepare(one.hand_in, settings.limit_s);
    Outcome outcome{1, {}};
    if (!hand_ins)
        outcome = run_command(command, ".", settings.limit_s, given_up);
    else if (not_built.empty())
        outcome = hand_ins->run(one, command, out, settings.limit_s, given_up);
    const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - begin;

    Result result = read_run(out);
    result.name = one.name;
    result.file = (one.hand_in.empty() ? "" : one.hand_in + ": ") + one.file.string();
    result.folder = folder;
    result.points = one.points;
    result.visibility = one.visibility;
    result.exit_code = outcome.code;
    result.wall_s = wall.count();
    if (!result.passed() || !result.failures.empty()) result.said = last_lines(outcome.output);
    if (!not_built.empty())
        result.end = "it could not be built: " + first_error(not_built);
    else if (outcome.code == WROTE_TOO_MUCH)
        result.end = "it wrote more than --output-limit allows";
    else if (outcome.code == TIMED_OUT)
        result.end = fmt::format("it did not end within {} s", settings.limit_s);
    else if (outcome.code > 128 + 2 || outcome.code == 127)
        result.end = fmt::format("it broke off: exit code {}", outcome.code);
    return result;
}

}  // namespace

void run_cases(const std::vector<Case>& cases, const RunSettings& settings,
               const std::function<bool()>& given_up, const std::function<void(Result)>& done) {
    std::atomic<std::size_t> next{0};
    std::atomic<bool> broken{false};
    std::exception_ptr error;  // the first
    std::mutex reporting;      // and that
    const auto enough = [&] { return broken || given_up(); };
    const auto work = [&] {
        try {
            for (std::size_t n; !enough() && (n = next++) < cases.size();) {
                Result result = run_case(cases[n], settings, enough);
                const std::lock_guard<std::mutex> lock{reporting};
                if (!enough()) done(std::move(result));
            }
        } catch (...) {
            const std::lock_guard<std::mutex> lock{reporting};
            if (!broken.exchange(true)) error = std::current_exception();
        }
    };
    std::vector<std::thread> threads;
    try {
        for (unsigned n = 1; n < settings.jobs; ++n) threads.emplace_back(work);
    } catch (const std::exception&) {
        // As many as the machine has room for.
    }
    work();
    for (std::thread& thread : threads) thread.join();
    if (error) std::rethrow_exception(error);
}

}  // namespace sim::suite
