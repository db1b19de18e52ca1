// run_again.h - a part of a run once more, for its waveforms.
//
// A run is the same every time, so nothing has to be kept in the first one.  The second one is the
// tracing build, as a process of its own, from the same description but for what it writes.
#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include "sim/report/report.h"
#include "sim/run/description.h"

namespace sim {

struct RunPart {
    std::filesystem::path folder;    // for waves.fst, waves.bus.txt, waves.calls.txt
    SimTime from, to;                // both after 0: a trace needs a time to begin
    std::filesystem::path scenario;  // to play instead of the run's own, or empty
};

// Runs it until its end, or until `given_up`.  Returns why there are no waveforms, or nothing.
// IoError: the folder cannot be made.
std::string run_part_again(const RunDescription& run, const RunPart& part,
                           const std::function<bool()>& given_up);

// Writes failure/ in the output folder, of the time run.outputs.trace_failure before the first
// failure in `report`, and adds to its text which files there are, or why there are none.
// `given_up`: the person does not want to wait for it.
void trace_failure(const RunDescription& run, RunReport& report,
                   const std::function<bool()>& given_up);

}  // namespace sim
