// results.h - what a run has come to: as a report, and as the lines that a person reads.
#pragma once

#include <filesystem>

#include "sim/board/board.h"
#include "sim/chip/computer_fabric.h"
#include "sim/chip/program_system.h"
#include "sim/report/report.h"
#include "sim/run/program_run.h"
#include "sim/run/recorder.h"
#include "sim/scenario/scenario_runner.h"

namespace sim {

// Adds to `report` what the board, the computer in its chip (if that is what is in it), its
// program (if it is an ARM's), the person at it and the recorder know.  `simulated_s` is the
// caller's, who knows when the run ended.  What they know without moving the board comes first:
// should a part of this throw, the rest is there.
void add_results(RunReport& report, Board& board, ProgramSystem* processor,
                 ComputerFabric* computer, ProgramRun* program, const ScenarioRunner& runner,
                 Recorder& recorder);

// What was missed and found, a line each on stderr, and a line on stdout.  False, with a line on
// stderr, where stdout could not be written.
[[nodiscard]] bool summarise(const RunReport& report, const std::filesystem::path& out);

}  // namespace sim
