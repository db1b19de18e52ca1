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
    double seconds;   // for all contenders together, except that
    unsigned rounds;  // so many are always run
};

// A round is all ticks of the workload by each contender in turn, so that what disturbs the
// machine disturbs all.  A contender's first round is not counted, nor the first tick of a round,
// so a workload needs two.  Boxes and pairs lie where they lay the tick before.  Throws
// std::runtime_error, with the name, if any tick's pairs are not the reference's.
std::vector<Result> race(const Workload& workload, const std::vector<Entry>& entries,
                         const Limits& limits);

// The one with the least time among those whose name begins with `name`; none if there is none.
std::optional<Result> best(const std::vector<Result>& results, const std::string& name);

}  // namespace bench
