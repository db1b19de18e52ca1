#include "tb/bench/table1/stopwatch.h"

#include <algorithm>
#include <cmath>

namespace table1 {

CpuTime CpuTime::now() {
    timespec fine{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &fine);
    return {1e3 * static_cast<double>(std::clock()) / CLOCKS_PER_SEC,
            1e3 * static_cast<double>(fine.tv_sec) + 1e-6 * static_cast<double>(fine.tv_nsec)};
}

Spread spread(std::vector<double> readings) {
    std::sort(readings.begin(), readings.end());
    const auto at = [&readings](double part) {
        const double last = static_cast<double>(readings.size() - 1);
        return readings[static_cast<std::size_t>(std::clamp(part, 0.0, 1.0) * last + 0.5)];
    };
    const double reach = 0.98 / std::sqrt(static_cast<double>(readings.size()));
    Spread found{at(0.5), at(0.25), at(0.75), 1};
    if (readings.size() >= 9)
        found.uncertainty = (at(0.5 + reach) - at(0.5 - reach)) / 2 / found.median;
    return found;
}

}  // namespace table1
