// run_client.h - whoever watches and plays a run from outside while it goes on: `de1sim live`
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "sim/board/board.h"
#include "sim/chip/computer_fabric.h"
#include "sim/chip/program_system.h"
#include "sim/run/plan.h"
#include "sim/run/program_run.h"
#include "sim/run/recorder.h"
#include "sim/scenario/scenario_runner.h"

namespace sim {

class RunClient {
public:
    virtual ~RunClient() = default;

    // What the board shows goes through it, and on to the recorder.
    virtual BoardObserver& observer() = 0;

    // The board is there, and time has not begun.  Null: there is no such thing in this run.
    struct Access {
        const RunPlan& plan;
        Board& board;
        ProgramSystem* processor;
        ComputerFabric* fabric;  // where the chip has this project's own
        ProgramRun* program;
        ScenarioRunner& runner;
    };
    virtual void attach(const Access& access) = 0;

    virtual bool has_left() const = 0;  // which ends the run
    // The run has ended: what is left of it waits for nobody's message.
    virtual void leave() = 0;
    // It is over, for these reasons.
    virtual void end(const std::vector<std::string>& faults) = 0;
};

// Makes the client at the other end of a socket.
using RunClientMaker = std::function<std::unique_ptr<RunClient>(int socket, Recorder& recorder)>;

}  // namespace sim
