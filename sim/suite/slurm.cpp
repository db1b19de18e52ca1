#include "sim/suite/slurm.h"

#include <sys/stat.h>

#include <chrono>
#include <set>
#include <sstream>
#include <stdexcept>
#include <thread>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "sim/files/whole_file.h"
#include "sim/process/run_command.h"
#include "sim/process/shell_word.h"
#include "sim/text/messages.h"
#include "sim/text/printable.h"

namespace sim::suite {

namespace {

namespace fs = std::filesystem;

constexpr unsigned ANSWER_S = 120, ROUNDS = 3;

std::string first_line(const std::string& text) { return text.substr(0, text.find('\n')); }

fs::path shard_folder(const TestOptions& options, unsigned number) {
    return options.out / "shards" / std::to_string(number);
}

std::string task(const TestOptions& options) {
    std::string text =
        "#!/bin/sh\nexec " + shell_word(fs::read_symlink("/proc/self/exe").string()) + " test";
    for (const fs::path& path : options.paths) text += " " + shell_word(path.string());
    if (!options.filter.empty()) text += " --filter " + shell_word(options.filter);
    if (!options.times.empty()) text += " --times " + shell_word(options.times.string());
    if (options.update_goldens) text += " --update-goldens";
    if (options.trace_failure) text += " --trace-failure " + to_string(*options.trace_failure);
    return text + fmt::format(
                      " --time-limit {} --jobs \"${{SLURM_CPUS_PER_TASK:-1}}\" --resume"
                      " --shard \"$SLURM_ARRAY_TASK_ID/{}\" --out {}/\"$SLURM_ARRAY_TASK_ID\"\n",
                      options.limit_s, options.shards,
                      shell_word((options.out / "shards").string()));
}

std::vector<std::string> words_of(const std::string& text) {
    std::istringstream stream{text};
    std::vector<std::string> command;
    for (std::string word; stream >> word;) command.push_back(word);
    return command;
}

// Whatever the shards have written so far.
Results collected(const TestOptions& options) {
    Results all;
    for (unsigned number = 1; number <= options.shards; ++number) {
        const fs::path folder = shard_folder(options, number);
        if (!fs::exists(folder / "results.json")) continue;
        for (Result result : read_results(folder).all) {
            result.folder = (fs::path{"shards"} / std::to_string(number) / result.folder).string();
            all.put(std::move(result));
        }
    }
    return all;
}

}  // namespace

SlurmJob::SlurmJob(const TestOptions& options, const std::vector<unsigned>& shards) {
    const fs::path folder = options.out / "slurm", script = folder / "task.sh";
    make_folder(folder);
    write_whole_file(script, task(options));
    chmod(script.c_str(), 0755);
    std::vector<std::string> command{"sbatch", "--parsable", "--job-name=de1sim",
                                     fmt::format("--array={}", fmt::join(shards, ",")),
                                     "--output=" + (folder / "%a.txt").string()};
    for (const std::string& word : words_of(options.sbatch)) command.push_back(word);
    command.push_back(script.string());
    const Outcome outcome = run_command(command, ".", ANSWER_S);
    if (outcome.code == 127) throw std::runtime_error{"--slurm: there is no sbatch on the PATH"};
    id_ = first_line(outcome.output);
    id_ = id_.substr(0, id_.find(';'));  // "17;cluster"
    if (outcome.code != 0 || id_.empty())
        throw std::runtime_error{"--slurm: " + printable(first_line(outcome.output))};
}

SlurmJob::~SlurmJob() {
    if (!id_.empty()) run_command({"scancel", id_}, ".", ANSWER_S);
}

bool SlurmJob::runs() {
    const Outcome outcome =
        run_command({"squeue", "--noheader", "--jobs=" + id_, "--format=%i"}, ".", ANSWER_S);
    // A job that is over for some minutes is unknown.  When the scheduler does not answer, it is
    // asked again.
    const bool unknown = outcome.output.find("Invalid job id") != std::string::npos;
    const bool over = unknown || (outcome.code == 0 && outcome.output.empty());
    if (over) id_.clear();
    return !over;
}

Results run_on_slurm(const std::vector<Case>& cases, const TestOptions& options,
                     const std::function<bool()>& given_up,
                     const std::function<void(const Result&)>& report) {
    std::error_code error;
    fs::remove_all(options.out / "shards", error);
    std::set<std::string> known;
    const auto look = [&] {
        Results all = collected(options);
        for (const Result& result : all.all)
            if (known.insert(result.name).second) report(result);
        return all;
    };
    for (unsigned round = 0; round < ROUNDS && !given_up(); ++round) {
        std::vector<unsigned> wanted;
        for (unsigned number = 1; number <= options.shards; ++number) {
            std::size_t lost = 0;
            for (const Case& one : shard(cases, number, options.shards))
                lost += !known.count(one.name);
            if (lost == 0) continue;
            wanted.push_back(number);
            if (round > 0)
                message(fmt::format("shard {}/{} has lost {} scenarios: they are submitted again",
                                    number, options.shards, lost));
        }
        if (wanted.empty()) break;
        SlurmJob job{options, wanted};
        while (!given_up() && job.runs()) {
            std::this_thread::sleep_for(std::chrono::milliseconds{500});
            look();
        }
        look();
    }
    Results results = look();
    for (const Case& one : cases) {
        results.suite.push_back(one.name);
        if (!results.find(one.name)) results.missing.push_back(one.name);
    }
    return results;
}

}  // namespace sim::suite
