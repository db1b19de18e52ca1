#include "sim/suite/command.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdio>
#include <map>
#include <optional>
#include <set>
#include <stdexcept>
#include <thread>
#include <tuple>
#include <utility>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "sim/files/whole_file.h"
#include "sim/process/interrupt.h"
#include "sim/report/exit_code.h"
#include "sim/run/options.h"
#include "sim/run/output_folder.h"
#include "sim/suite/cases.h"
#include "sim/suite/graders.h"
#include "sim/suite/index_page.h"
#include "sim/suite/reporter.h"
#include "sim/suite/results.h"
#include "sim/suite/runner.h"
#include "sim/suite/slurm.h"
#include "sim/text/messages.h"
#include "sim/text/printable.h"

namespace sim::suite {

namespace {

namespace fs = std::filesystem;

std::pair<unsigned, unsigned> parse_shard(const std::string& text) {
    unsigned number = 0, count = 0;
    char rest = 0;
    if (std::sscanf(text.c_str(), "%u/%u%c", &number, &count, &rest) != 2 || number < 1 ||
        number > count)
        throw CLI::ValidationError("--shard",
                                   "expected I/N with I from 1 to N, got \"" + text + "\"");
    return {number, count};
}

void write_all(const fs::path& out, const Results& results, const TestOptions& options = {}) {
    write_results(out, results);
    write_junit(out, results);
    write_whole_file(out / "index.html", to_index(out, results));
    if (!options.gradescope.empty())
        write_whole_file(options.gradescope, to_gradescope(out, results));
    if (!options.classroom.empty()) write_whole_file(options.classroom, to_classroom(results));
    if (!options.hand_ins.csv.empty()) write_whole_file(options.hand_ins.csv, to_csv(results));
}

// Writes results.json now and then, so that a machine that dies loses little.
class Keeper {
public:
    Keeper(const fs::path& out, Results& results) : out_{out}, results_{results} {}

    void keep(Result result) {
        results_.put(std::move(result));
        const auto now = std::chrono::steady_clock::now();
        if (now < next_) return;
        write_results(out_, results_);
        next_ = now + std::chrono::seconds{1};
    }

private:
    const fs::path out_;
    Results& results_;
    std::chrono::steady_clock::time_point next_{};
};

int test_on_slurm(TestOptions options, const std::vector<Case>& cases) {
    options.shards = std::min(options.tasks, static_cast<unsigned>(cases.size()));
    options.out = fs::absolute(options.out);
    const OutputFolder folder{options.out};
    note_interrupts();
    Reporter reporter{cases, options.shards};
    const Results results = run_on_slurm(cases, options, interrupted,
                                         [&](const Result& result) { reporter.done(result); });
    write_all(options.out, results, options);
    if (!summarise(results, reporter.wall_s(), options.out)) return WRONG_INPUT;
    return interrupted() ? INTERRUPTED : results.exit_code();
}

int print_list(const std::vector<Case>& cases) {
    std::string text;
    for (const Case& one : cases) text += printable(one.name) + "\n";
    return print_result(text) ? PASSED : WRONG_INPUT;
}

void add_hand_in_options(CLI::App& command, HandInOptions& options) {
    CLI::Option* folder =
        command
            .add_option(
                "--hand-ins", options.folder,
                "folder with a folder for each hand-in: every scenario judges each, by the\n"
                "file in it that the scenario names as `program:` or `project:`")
            ->excludes("--update-goldens")
            ->excludes("--gradescope")
            ->excludes("--classroom");
    command
        .add_option("--build", options.build,
                    "command of a shell that makes that file, run in a copy of each hand-in")
        ->needs(folder);
    command.add_option("--csv", options.csv, "file for a table with a row for each hand-in")
        ->needs(folder);
    command.add_option("--memory-limit", options.memory_mb, "MB that a hand-in's run may use")
        ->check(CLI::Range(1'500, 1'000'000))
        ->needs(folder)
        ->capture_default_str();
    command.add_option("--output-limit", options.output_mb, "MB that a hand-in's run may write")
        ->check(CLI::Range(1, 1'000'000))
        ->needs(folder)
        ->capture_default_str();
    command
        .add_flag("--unconfined", options.unconfined,
                  "run hand-ins with all rights of yours, where bwrap cannot be used")
        ->needs(folder);
}

}  // namespace

void add_test_options(CLI::App& command, TestOptions& options) {
    command.add_option("PATH", options.paths, "scenarios, or folders of them")->required();
    command
        .add_option("--out", options.out,
                    "folder for index.html, junit.xml, results.json and runs/NAME/")
        ->capture_default_str();
    command
        .add_option("--jobs", options.jobs,
                    "scenarios that run at once; 0: as many as the machine has processors")
        ->check(CLI::Range(0, 1024))
        ->capture_default_str();
    command.add_option("--time-limit", options.limit_s, "seconds that a scenario may take")
        ->check(CLI::Range(1, 1'000'000))
        ->capture_default_str();
    command.add_option("--filter", options.filter,
                       "only scenarios with this in their name; with * or ? the whole name");
    command.add_flag("--list", options.list, "print their names, and run none");
    command.add_flag("--rerun-failed", options.rerun_failed,
                     "only those that did not pass the last time; the others' results stay");
    command.add_flag("--fail-fast", options.fail_fast, "end with the first that fails");
    command.add_flag(
        "--update-goldens", options.update_goldens,
        "replace golden pictures that differ, and write those that are not there yet;\n"
        "old and new are in index.html");
    command.add_option_function<std::string>(
        "--shard",
        [&](const std::string& text) {
            std::tie(options.shard, options.shards) = parse_shard(text);
        },
        "I/N: only the Ith of N parts of about the same length, for de1sim merge");
    command.add_option("--times", options.times,
                       "folder of results whose times tell how long each takes, for --shard;\n"
                       "without it lengths are estimated, the same way on every machine");
    command.add_option("--gradescope", options.gradescope,
                       "file for Gradescope's autograder, /autograder/results/results.json: the\n"
                       "points of each scenario, and what was expected and found");
    command.add_option(
        "--classroom", options.classroom,
        "file for the output `result` of a step in GitHub Classroom's workflow: the\n"
        "points of each scenario");
    add_hand_in_options(command, options.hand_ins);
    CLI::Option* slurm = command.add_flag(
        "--slurm", options.slurm, "run on a cluster: as an array job of Slurm's, a task per shard");
    for (const char* other : {"--shard", "--rerun-failed", "--fail-fast", "--jobs", "--hand-ins"})
        slurm->excludes(other);
    command.add_option("--shards", options.tasks, "tasks of that job")
        ->check(CLI::Range(1, 1000))
        ->needs(slurm)
        ->capture_default_str();
    command
        .add_option("--sbatch", options.sbatch,
                    "options of sbatch, as one word: '--partition=short --time=30'")
        ->needs(slurm);
    command.add_flag("--resume", options.resume,
                     "keep the results that --out has, and run the other scenarios");
    add_time_option(command, "--trace-failure", options.trace_failure,
                    "run what fails again, for the waveforms of this time before");
}

int test(const TestOptions& options) {
    std::vector<Case> cases = find_cases(options.paths);
    std::optional<HandIns> hand_ins;
    if (!options.hand_ins.folder.empty()) {
        hand_ins.emplace(options.hand_ins, options.paths, options.out);
        cases = hand_ins->cases(cases);
    }
    if (!options.filter.empty()) cases = filtered(std::move(cases), options.filter);
    if (cases.empty())
        throw std::runtime_error{"--filter: no scenario has \"" + printable(options.filter) +
                                 "\" in its name"};
    const bool measured = fs::exists(options.out / "results.json");
    if (!options.times.empty())
        use_times(cases, read_results(options.times).times_s());
    else if (options.shards == 1 && !options.slurm && measured)
        use_times(cases, read_results(options.out).times_s());

    Results results;
    for (const Case& one : cases) results.suite.push_back(one.name);
    results.shard = options.shard;
    results.shards = options.shards;
    if (!options.slurm) cases = shard(std::move(cases), options.shard, options.shards);
    if (options.rerun_failed || (options.resume && measured)) {
        const Results before = read_results(options.out);
        const auto done = [&](const Case& one) {
            const Result* result = before.find(one.name);
            return result && (options.resume || result->passed());
        };
        for (const Case& one : cases)
            if (done(one)) results.put(*before.find(one.name));
        cases.erase(std::remove_if(cases.begin(), cases.end(), done), cases.end());
    }
    if (options.list) return print_list(cases);
    if (options.slurm) return test_on_slurm(options, cases);
    for (const Case& one : cases) results.missing.push_back(one.name);

    const OutputFolder folder{options.out};
    note_interrupts();
    RunSettings settings;
    settings.out = options.out;
    settings.update_goldens = options.update_goldens;
    settings.trace_failure = options.trace_failure;
    settings.jobs = options.jobs ? options.jobs : std::max(1u, std::thread::hardware_concurrency());
    settings.limit_s = options.limit_s;
    if (hand_ins) settings.hand_ins = &*hand_ins;
    Reporter reporter{cases, settings.jobs};
    Keeper keeper{options.out, results};
    std::atomic<bool> enough{false};
    run_cases(
        cases, settings, [&] { return interrupted() || enough; },
        [&](Result result) {
            reporter.done(result);
            if (options.fail_fast && !result.passed()) enough = true;
            keeper.keep(std::move(result));
        });
    std::sort(results.missing.begin(), results.missing.end());
    write_all(options.out, results, options);
    if (!summarise(results, reporter.wall_s(), options.out)) return WRONG_INPUT;
    return interrupted() ? INTERRUPTED : results.exit_code();
}

int merge(const std::vector<fs::path>& folders, const fs::path& out) {
    Results merged;
    std::set<unsigned> shards;
    make_folder(out);
    for (const fs::path& folder : folders) {
        const Results part = read_results(folder);
        if (merged.suite.empty()) {
            merged.suite = part.suite;
            merged.shards = part.shards;
        }
        if (part.suite != merged.suite || part.shards != merged.shards)
            throw std::runtime_error{printable(folder.string()) +
                                     ": expected a part of the same scenarios as in " +
                                     printable(folders.front().string()) + ", got others"};
        shards.insert(part.shard);
        for (Result result : part.all) {
            const fs::path runs = fs::absolute(folder / result.folder).lexically_normal();
            result.folder = runs.lexically_relative(fs::absolute(out).lexically_normal()).string();
            merged.put(std::move(result));
        }
    }
    for (const std::string& name : merged.suite)
        if (!merged.find(name)) merged.missing.push_back(name);
    for (unsigned number = 1; number <= merged.shards; ++number)
        if (!shards.count(number))
            message(fmt::format("shard {}/{} is missing", number, merged.shards));
    merged.shards = 1;
    double wall_s = 0;
    for (const Result& result : merged.all) wall_s += result.wall_s;
    write_all(out, merged);
    if (!summarise(merged, wall_s, out)) return WRONG_INPUT;
    return merged.exit_code();
}

}  // namespace sim::suite
