// trace_notes.h - what a run with --trace-from or --trace-to leaves beside its waveforms, FILE.fst:
// FILE.bus.txt and FILE.calls.txt.
#pragma once

#include <optional>

#include "sim/chip/program_system.h"
#include "sim/hps/bus_log.h"
#include "sim/run/description.h"
#include "sim/run/program_run.h"

namespace sim {

class TraceNotes {
public:
    // Watches the computer's bus from now on.  `program`: its own, or null.
    TraceNotes(ProgramSystem& computer, const ProgramRun* program, const TraceDescription& trace);
    void write() const;  // IoError

private:
    const TraceDescription& trace_;
    const ProgramRun* const program_;
    BusLog bus_;
};

}  // namespace sim
