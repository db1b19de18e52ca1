// trace_notes.cpp - see trace_notes.h
#include "sim/run/trace_notes.h"

#include "sim/files/whole_file.h"

namespace sim {

namespace {

sc_core::sc_time time_of(std::optional<SimTime> time, const sc_core::sc_time& otherwise) {
    return time ? sc_core::sc_time::from_value(time->ps) : otherwise;
}

BusLog::Program program_of(ProgramCpu* cpu) {
    if (!cpu) return {};
    return {[cpu] { return cpu->instruction(); },
            [cpu](std::uint32_t at) { return cpu->elf().function(at); }};
}

}  // namespace

TraceNotes::TraceNotes(ProgramSystem& computer, const ProgramRun* program,
                       const TraceDescription& trace)
    : trace_{trace},
      program_{program},
      bus_{computer.processor_bus(), time_of(trace.from, sc_core::SC_ZERO_TIME),
           time_of(trace.to, sc_core::sc_max_time()), program_of(computer.program_cpu())} {}

void TraceNotes::write() const {
    std::filesystem::path file{trace_.file};
    write_whole_file(file.replace_extension(".bus.txt"), bus_.text());
    if (program_ && program_->calls())
        write_whole_file(std::filesystem::path{trace_.file}.replace_extension(".calls.txt"),
                         program_->calls()->text());
}

}  // namespace sim
