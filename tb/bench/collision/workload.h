// workload.h - worlds of boxes, one per tick, on a grid that a float represents exactly.
#pragma once

#include "contender.h"

namespace bench {

struct Workload {
    std::string name;          // "uniform"
    std::vector<Boxes> ticks;  // all with the same number of boxes
};

// All boxes new every tick, `size` > 1 of them, with about 1.5 pairs that overlap for each box.
Workload uniform(unsigned size, unsigned ticks);
Workload clustered(unsigned size, unsigned ticks);     // each box in one of 20 normal distributions
Workload heavy_tailed(unsigned size, unsigned ticks);  // sides 1 : 1000, Pareto with exponent 1

// The uniform world, in which each box moves straight on by a tenth of its size per tick.
Workload coherent(unsigned size, unsigned ticks);

}  // namespace bench
