// race.h - contenders timed side by side on one workload, every tick's pairs checked.
#pragma once

#include <optional>

#include "contender.h"
#include "workload.h"

namespace bench {

struct Result {
    std::string name;
    double ns_a_box;  // median over all ticks
};

struct Limits {
    double seconds;   // limit for all contenders together; but
    unsigned rounds;  // at least so many rounds are run
};

// In a round each contender in turn runs all ticks of the workload, so that disturbances of the
// machine affect all.  A contender's first round and the first tick of each round are not counted,
// so a workload needs at least two ticks.  Boxes and pairs keep their addresses from tick to tick.
// Throws std::runtime_error, with the name, if any tick's pairs are not the reference's.
std::vector<Result> race(const Workload& workload, const std::vector<Entry>& entries,
                         const Limits& limits);

// The one with the least time among those whose name begins with `name`; none if there is none.
std::optional<Result> best(const std::vector<Result>& results, const std::string& name);

}  // namespace bench
