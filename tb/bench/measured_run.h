// measured_run.h - one `de1sim run` as a process of its own: its time, its memory, its frames.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace bench {

struct MeasuredRun {
    double wall_s = 0;  // from start to end of the process
    double peak_mb = 0;
    std::uint64_t frames = 0;        // PNG files written
    double cpu_s = 0;                // of all of its threads
    std::uint64_t instructions = 0;  // of the program's, with --cpu arm
    double busy_share = 0;           // share of a frame in which it is awake, median; with --cpu
                                     // arm
    std::uint64_t shown = 0, swapped = 0;  // frames; those with a new picture
};

// Writes every frame, or what `options` say, into `out`, which is removed before and after.
// std::runtime_error if it does not end as a run of `duration_s` should.  Missed expectations of
// the scenario are no error then, because a shortened run cannot meet them all.  Without
// `duration_s` the scenario ends the run, and must be met.
MeasuredRun measure_run(const std::string& de1sim, const std::string& scenario,
                        std::optional<unsigned> duration_s, const std::filesystem::path& out,
                        const std::vector<std::string>& options = {"--frames", "all"});

// How often each is measured, and how long a run is.
constexpr unsigned RUNS = 3, DURATION_S = 3;

double median(std::vector<double> values);  // not of none

}  // namespace bench
