// trace_notes.cpp - see trace_notes.h
#include "sim/run/trace_notes.h"

#include "sim/files/whole_file.h"

namespace sim {

namespace {

sc_core::sc_time time_of(std::optional<SimTime> time, const sc_core::sc_time& otherwise) {
    return time ? sc_core::sc_time::from_value(time->ps) : otherwise;
}

BusLog::Program program_of(ArmCpu* arm) {
    if (!arm) return {};
    return {[arm] { return arm->core().instruction(); },
            [arm](std::uint32_t at) { return arm->program().elf.function(at); }};
}

}  // namespace

TraceNotes::TraceNotes(ProcessorSystem& computer, const ArmRun* arm, const TraceDescription& trace)
    : trace_{trace},
      arm_{arm},
      bus_{computer.bus, time_of(trace.from, sc_core::SC_ZERO_TIME),
           time_of(trace.to, sc_core::sc_max_time()), program_of(computer.arm)} {}

void TraceNotes::write() const {
    std::filesystem::path file{trace_.file};
    write_whole_file(file.replace_extension(".bus.txt"), bus_.text());
    if (arm_ && arm_->calls())
        write_whole_file(std::filesystem::path{trace_.file}.replace_extension(".calls.txt"),
                         arm_->calls()->text());
}

}  // namespace sim
