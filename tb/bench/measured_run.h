// measured_run.h - one `de1sim run` as a process of its own: its time, its memory, its frames.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

namespace bench {

struct MeasuredRun {
    double wall_s = 0;  // from start to end of the process
    double peak_mb = 0;
    std::uint64_t frames = 0;  // PNG files written
};

// Every frame is written into `out`, which is removed before and after.  std::runtime_error if it
// does not end as a run of `duration_s` should; a scenario's missed expectations are none of that,
// since a shortened run cannot meet them all.
MeasuredRun measure_run(const std::string& de1sim, const std::string& scenario, unsigned duration_s,
                        const std::filesystem::path& out);

}  // namespace bench
