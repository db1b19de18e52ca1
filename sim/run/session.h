// session.h - one run as a value: a chip with its program on the board, and who watches it.
//
//   RunDescription --plan_run()--> RunPlan --> Observers, System --run()--> report and files
//
// Exactly one per process: SystemC elaborates once.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <variant>

#include "sim/board/board.h"
#include "sim/chip/computer.h"
#include "sim/debug/debugger.h"
#include "sim/files/trace_file.h"
#include "sim/project/build.h"
#include "sim/report/exit_code.h"
#include "sim/run/arm_run.h"
#include "sim/run/crash_report.h"
#include "sim/run/nios_v_run.h"
#include "sim/run/plan.h"
#include "sim/run/progress.h"
#include "sim/run/recorder.h"
#include "sim/run/run_client.h"
#include "sim/run/run_loop.h"
#include "sim/run/run_page.h"
#include "sim/run/trace_notes.h"
#include "sim/scenario/scenario_runner.h"

namespace sim {

// Those who watch: files, standard output, the page of the run, waveforms, `de1sim live`.
struct Observers {
    // Makes the output folder and opens the files.  IoError.
    Observers(const RunPlan& plan, const RunClientMaker& make_client);

    Recorder recorder;
    std::optional<ProgramOutput> output;
    std::optional<RunPage> page;
    std::optional<TraceFile> trace;
    std::unique_ptr<RunClient> client;  // or null

    BoardObserver& all() { return client ? client->observer() : recorder; }
};

// What runs, and so which processor the chip has.
using Software = std::variant<Firmware, ArmProgram, NiosVProgram>;

// What is simulated: the board, the chip on it, its program, and the person who plays at it.
struct System {
    // `built`: the project in the chip, or nothing.  std::runtime_error: it has no processor.
    System(const RunPlan& plan, Software software, const std::optional<project::Built>& built,
           Observers& observers);

    // Null: there is none in this chip.  `fabric`: where it has this project's own.
    ProgramSystem* processor = nullptr;
    ComputerFabric* fabric = nullptr;
    ProcessorSystem* hps = nullptr;
    NiosVComputer* nios_v_computer = nullptr;
    Board board;
    std::optional<ArmRun> arm;
    std::optional<NiosVRun> nios_v;
    std::optional<TraceNotes> trace_notes;
    ScenarioRunner runner;

    // Null: the processor runs no ELF, or there is none.
    ProgramRun* program_run() {
        if (arm) return &*arm;
        return nios_v ? &*nios_v : nullptr;
    }

private:
    std::unique_ptr<Chip> chip_for(const RunPlan& plan, Software software,
                                   const std::optional<project::Built>& built,
                                   const std::string& trace_part, PinListener& pins,
                                   ChipObserver& observer, std::uint8_t* sdram);
};

class Session {
public:
    // Reads the program, builds the project, opens the files, makes the board.  ElfError; IoError;
    // std::runtime_error.
    Session(RunPlan plan, const Firmware& firmware, const RunClientMaker& make_client);

    // Simulates, and writes the files and the summary.  IoError.
    ExitCode run();

private:
    std::unique_ptr<Debugger> debugger();
    void simulate();
    void write_files();
    void conclude();
    ExitCode write_report();
    template <class Part>
    void carry_out(const char* doing, Part part);

    RunPlan plan_;
    Software software_;  // until the system has it
    std::optional<GdbConnection> gdb_;
    Observers observers_;
    const std::optional<project::Built> built_;
    System system_;
    const sc_core::sc_event never_;
    Finish finish_;
    std::unique_ptr<Debugger> debugger_;  // null: nobody asked for one
    Progress progress_;
    RunReport report_;
    CrashReport crash_report_;
    std::vector<std::string> failures_;  // of the simulator itself
};

}  // namespace sim
