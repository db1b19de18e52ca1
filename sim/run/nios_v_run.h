// nios_v_run.h - what a run with Nios V has besides: its ELF
#pragma once

#include <optional>

#include "sim/chip/nios_v_computer.h"
#include "sim/profile/nios_v_profile.h"
#include "sim/run/plan.h"
#include "sim/run/program_run.h"

namespace sim {

// ElfError; std::runtime_error for options that this processor's programs do not have.
NiosVProgram load_nios_v_program(const RunPlan& plan);

class NiosVRun final : public ProgramRun {
public:
    NiosVRun(NiosVComputer& computer, const RunPlan& plan, Recorder& recorder);

    RunReport::Program program() const override;
    std::vector<std::string> missed_interrupts() override;
    void write_profile() override;

private:
    NiosVComputer& computer_;
    std::optional<NiosVProfile> runs_;
};

}  // namespace sim
