// slurm.h - de1sim test on a cluster: an array job of Slurm's, a task per shard
//
//   OUT/slurm/task.sh      what a task does: de1sim test ... --shard I/N --resume
//   OUT/slurm/I.txt        what it says
//   OUT/shards/I/          its results, which are merged into OUT
//
// Nodes see the same folders under the same names: the scenarios, OUT, de1sim.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "sim/suite/cases.h"
#include "sim/suite/command.h"
#include "sim/suite/results.h"

namespace sim::suite {

class SlurmJob {
public:
    // Submits these shards.  std::runtime_error with what sbatch says.
    SlurmJob(const TestOptions& options, const std::vector<unsigned>& shards);
    // Cancels what still runs.
    ~SlurmJob();
    SlurmJob(const SlurmJob&) = delete;
    SlurmJob& operator=(const SlurmJob&) = delete;

    // Asks the scheduler.  A task that has ended, however that was, is no longer there.
    bool runs();

private:
    std::string id_;
};

// Submits, waits and merges.  Shards of which scenarios have no result, since their node died or
// their task was cancelled, are submitted again, twice at most: these scenarios alone run again.
// `report` hears of each result as it comes.
Results run_on_slurm(const std::vector<Case>& cases, const TestOptions& options,
                     const std::function<bool()>& given_up,
                     const std::function<void(const Result&)>& report);

}  // namespace sim::suite
