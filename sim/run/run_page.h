// run_page.h - the page of a run (--html): filled while it goes on, written at its end
#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

#include "sim/page/page.h"
#include "sim/run/description.h"
#include "sim/run/program_run.h"
#include "sim/run/recorder.h"
#include "sim/scenario/scenario.h"
#include "sim/scenario/scenario_runner.h"

namespace sim {

class RunPage {
public:
    // Has the recorder keep what the page needs.  The file is there, empty, in the folder of the
    // page from now on, so that a wrong name is refused before the run: IoError.
    RunPage(const RunDescription& run, Recorder& recorder);
    RunPage(const RunPage&) = delete;
    RunPage& operator=(const RunPage&) = delete;

    void step_done();
    // IoError.
    void write(const RunReport& report, const Scenario& scenario, const ScenarioRunner& runner,
               const ProgramRun* program);

private:
    Recorder& recorder_;
    WholeFile file_;
    page::Page page_;
    std::vector<std::uint64_t> frame_of_step_;
};

}  // namespace sim
