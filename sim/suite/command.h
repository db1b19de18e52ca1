// command.h - `de1sim test` and `de1sim merge`
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "sim/scenario/sim_time.h"
#include "sim/suite/hand_ins.h"

namespace CLI {
class App;
}

namespace sim::suite {

struct TestOptions {
    std::vector<std::filesystem::path> paths;
    std::filesystem::path out = "test-results";
    unsigned jobs = 0;  // 0: as many as the machine has processors
    unsigned limit_s = 3600;
    std::string filter;
    bool slurm = false;
    unsigned tasks = 8;   // of a job of Slurm's
    std::string sbatch;   // options of sbatch, between blanks
    bool resume = false;  // what has a result does not run again
    bool list = false, rerun_failed = false, fail_fast = false, update_goldens = false;
    unsigned shard = 1, shards = 1;
    std::filesystem::path times;       // results whose times are used; or empty
    std::filesystem::path gradescope;  // file for Gradescope; or empty
    std::filesystem::path classroom;   // file for GitHub Classroom; or empty
    HandInOptions hand_ins;
    std::optional<SimTime> trace_failure;
};

void add_test_options(CLI::App& command, TestOptions& options);
// Prints a line per scenario, the failures last, and a summary on stdout.  An exit code of `run`,
// the worst of all.  std::runtime_error for what it cannot begin with.
int test(const TestOptions& options);

// Joins the results of shards in these folders into one, in `out`.
int merge(const std::vector<std::filesystem::path>& folders, const std::filesystem::path& out);

}  // namespace sim::suite
