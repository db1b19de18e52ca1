// run_again.h - a part of a run once more, for its waveforms.
//
// A run is the same every time, so nothing has to be kept in the first one.  The second one is the
// tracing build, as a process of its own with the same words.
#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include "sim/report/report.h"
#include "sim/run/options.h"

namespace sim {

struct RunPart {
    std::filesystem::path folder;    // for waves.fst, waves.bus.txt, waves.calls.txt
    SimTime from, to;                // both after 0: a trace needs a time to begin
    std::filesystem::path scenario;  // to play instead of the run's own, or empty
};

// Runs it until its end, or until `given_up`.  Returns why there are no waveforms, or nothing.
// IoError: the folder cannot be made.
std::string run_part_again(const RunOptions& options, const RunPart& part,
                           const std::function<bool()>& given_up);

// Writes options.out/failure/ of the time options.trace_failure before the first failure in
// `report`, and adds to that failure's words which files there are, or why there are none.
// `given_up`: the person does not want to wait for it.
void trace_failure(const RunOptions& options, RunReport& report,
                   const std::function<bool()>& given_up);

}  // namespace sim
