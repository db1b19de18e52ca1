// trace_notes.h - what a run with --trace-from or --trace-to leaves beside its waveforms, FILE.fst:
// FILE.bus.txt and FILE.calls.txt.
#pragma once

#include <optional>

#include "sim/chip/processor_system.h"
#include "sim/hps/bus_log.h"
#include "sim/run/arm_run.h"
#include "sim/run/description.h"

namespace sim {

class TraceNotes {
public:
    // Watches the computer's bus from now on.  `arm`: its program, or null.
    TraceNotes(ProcessorSystem& computer, const ArmRun* arm, const TraceDescription& trace);
    void write() const;  // IoError

private:
    const TraceDescription& trace_;
    const ArmRun* const arm_;
    BusLog bus_;
};

}  // namespace sim
