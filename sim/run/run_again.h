// run_again.h - a run that has failed, once more, for the waveforms of the time before the failure.
//
// A run is the same every time, so nothing has to be kept in the first one.  The second one is the
// tracing build, as a process of its own with the same words.
#pragma once

#include <functional>

#include "sim/report/report.h"
#include "sim/run/options.h"

namespace sim {

// Writes options.out/failure/ of the time options.trace_failure before the first failure in
// `report`, and adds to that failure's words which files there are, or why there are none.
// `given_up`: the person does not want to wait for it.
void run_again(const RunOptions& options, RunReport& report, const std::function<bool()>& given_up);

}  // namespace sim
