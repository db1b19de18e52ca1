// stopwatch.h - CPU time of this process by two clocks, and statistics of readings.
#pragma once

#include <ctime>
#include <vector>

namespace table1 {

struct CpuTime {
    double clock_ms;  // std::clock, as in the paper: microseconds here
    double fine_ms;   // CLOCK_PROCESS_CPUTIME_ID: nanoseconds

    static CpuTime now();
};

inline CpuTime operator-(CpuTime a, CpuTime b) {
    return {a.clock_ms - b.clock_ms, a.fine_ms - b.fine_ms};
}

// Of readings of the same thing.
struct Spread {
    double median = 0;
    double low = 0, high = 0;  // the quartiles
    double uncertainty = 1;    // half the 95 % interval of the median, relative to it
};

// The interval is that of order statistics: no distribution is assumed.  At least one reading.
Spread spread(std::vector<double> readings);

}  // namespace table1
