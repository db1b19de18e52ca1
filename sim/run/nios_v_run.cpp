#include "sim/run/nios_v_run.h"

#include "sim/run/missed_interrupts.h"

namespace sim {

NiosVProgram load_nios_v_program(const RunPlan& plan) {
    const ProgramDescription& program = plan.description.program;
    ElfProgram elf = load_elf(program.elf, nios_v_memory());
    elf.leave_only_sections();
    return {std::move(elf), program.cpi};
}

NiosVRun::NiosVRun(NiosVComputer& computer, const RunPlan& plan, Recorder& recorder)
    : ProgramRun{computer.cpu, computer.bus, plan, recorder}, computer_{computer} {
    if (Profile* const wanted = profile()) runs_.emplace(computer.cpu.core(), *wanted);
}

void NiosVRun::write_profile() {
    if (runs_) runs_->finish();
    ProgramRun::write_profile();
}

RunReport::Program NiosVRun::program() const {
    RunReport::Program program = ProgramRun::program();
    program.exit_code = computer_.cpu.exit_code();
    return program;
}

std::vector<std::string> NiosVRun::missed_interrupts() { return sim::missed_interrupts(computer_); }

}  // namespace sim
