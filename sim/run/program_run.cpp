#include "sim/run/program_run.h"

#include <fmt/format.h>

#include "sim/files/whole_file.h"
#include "sim/text/seconds.h"

namespace sim {

ProgramRun::ProgramRun(ProgramCpu& cpu, const Bus& bus, const RunPlan& plan, Recorder& recorder)
    : program_cpu_{cpu}, program_bus_{bus}, profile_file_{plan.description.outputs.profile} {
    const TraceDescription& trace = plan.description.outputs.trace;
    if (!profile_file_.empty() || trace.is_of_a_part()) profile_.emplace(cpu.elf());
    if (trace.is_of_a_part())
        calls_.emplace(
            *profile_, cpu,
            trace.to ? sc_core::sc_time::from_value(trace.to->ps) : sc_core::sc_max_time());
    recorder.on_frame = [this] {
        budget_.frame_ended(program_cpu_.counts(), sc_core::sc_time_stamp());
    };
}

RunReport::Program ProgramRun::program() const {
    const ProgramCpu::Counts counts = program_cpu_.counts();
    const ProgramCpu::Position at = program_cpu_.position();
    RunReport::Program program;
    program.elf = program_cpu_.elf().file.string();
    program.cpi = program_cpu_.cpi();
    program.instructions = counts.instructions;
    program.interrupts = counts.interrupts;
    program.aborts = counts.aborts;
    program.asleep_s = seconds(counts.asleep);
    program.on_bus_s = seconds(counts.on_bus);
    program.pc = at.pc;
    program.function = at.function;
    program.frames = budget_.figures();
    program.waiting = waiting();
    return program;
}

std::string ProgramRun::waiting() const {
    const ProgramCpu::Position at = program_cpu_.position();
    if (at.ended) return "nothing: it has ended";
    if (at.sleeping) return "an interrupt";
    if (!at.polled) return "";
    const std::string name = program_bus_.register_at(*at.polled);
    return fmt::format("a change of 0x{:08X}{}{}{}", *at.polled, name.empty() ? "" : " (", name,
                       name.empty() ? "" : ")");
}

void ProgramRun::write_profile() {
    if (!profile_file_.empty()) write_whole_file(profile_file_, profile_->callgrind());
}

}  // namespace sim
