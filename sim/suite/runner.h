// runner.h - runs scenarios in parallel, each as a process of its own
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <vector>

#include "sim/scenario/sim_time.h"
#include "sim/suite/cases.h"
#include "sim/suite/hand_ins.h"
#include "sim/suite/results.h"

namespace sim::suite {

struct RunSettings {
    std::filesystem::path out;  // runs/NAME/ in it
    bool update_goldens = false;
    std::optional<SimTime> trace_failure = {};  // as RunOutputs has it
    unsigned jobs = 1;                          // at once
    unsigned limit_s = 3600;                    // of wall time for a scenario
    HandIns* hand_ins = nullptr;                // for cases that have a `hand_in`
};

// Runs them in their order.  `done` is called with each as it ends, one call at a time; a case that
// given_up() has cut off or kept from beginning has no result.  What `done` throws ends them all
// and is thrown on.
void run_cases(const std::vector<Case>& cases, const RunSettings& settings,
               const std::function<bool()>& given_up, const std::function<void(Result)>& done);

}  // namespace sim::suite
