// run_loop.h - lets simulated time pass, a millisecond after another, until the run has an end.
//
// When the program has faulted, the chip goes on until its host has what the program printed
// before, as on the board: 10 ms at most.
#pragma once

#include <optional>

#include "sim/board/board.h"
#include "sim/chip/program_system.h"
#include "sim/debug/debugger.h"
#include "sim/report/report.h"
#include "sim/run/crash_report.h"
#include "sim/run/progress.h"
#include "sim/run/recorder.h"
#include "sim/run/run_client.h"
#include "sim/scenario/scenario_runner.h"

namespace sim {

// Ends sc_start when the steps are done (unless a duration says when) or the firmware has faulted.
class Finish : public sc_core::sc_module {
public:
    Finish(const sc_core::sc_module_name& name, const sc_core::sc_event& done,
           const sc_core::sc_event& faulted);

private:
    void pause() { sc_core::sc_pause(); }
};

struct RunLoop {
    Board& board;
    ProgramSystem* computer;  // in the chip, or none
    ScenarioRunner& runner;
    Recorder& recorder;
    std::optional<SimTime> duration;
    bool alone;  // the program has no scenario, which would say when the run ends
    Progress& progress;
    Debugger* debugger;  // or none
    RunClient* client;   // or none
    CrashReport& crash_report;

    RunEnd run();

private:
    std::optional<RunEnd> end();
    void empty_the_consoles();
};

}  // namespace sim
