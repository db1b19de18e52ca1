// plan.h - a run that is decided: the description, with what its scenario adds and the defaults
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "sim/board/monitor.h"
#include "sim/project/board_description.h"
#include "sim/run/description.h"
#include "sim/scenario/scenario.h"

namespace sim {

struct RunPlan {
    enum class Processor { NONE, NATIVE, ARM, NIOS_V };

    RunDescription
        description;    // with the project, the program and the board that the scenario names
    Scenario scenario;  // empty: the program alone
    Processor processor = Processor::NATIVE;
    // Whose computer is in the chip, by its name; none: the DE1-SoC's, or a project.
    std::optional<project::BoardDescription> computer_of;
    bool on_linux = false;  // the ARM's program
    std::uint64_t seed = 1;
    std::optional<SimTime> duration;
    bool bridged_memory = false;
    unsigned audio_rate = 8'000;  // samples per second
    unsigned ddr3_mb_per_s = 0;   // for a project's masters
    Monitor::Strictness strictness = Monitor::Strictness::STRICT;

    bool has_program() const {
        return processor == Processor::ARM || processor == Processor::NIOS_V;
    }
    bool has_project() const { return !description.chip.project.place.empty(); }
    // As reports name it.
    const char* cpu() const {
        return processor == Processor::ARM      ? "arm"
               : processor == Processor::NIOS_V ? "nios-v"
               : processor == Processor::NATIVE ? "native"
                                                : "none";
    }
};

// "expected a Linux program ..., got ..."; or "" if this run has what the step needs.
std::string missing_for(const RunPlan& plan, const Step& step);

// Looks whether the board has what the plan's scenario needs.  ScenarioError; std::runtime_error:
// there is a program, and the board's chip has no processor.
void set_board(RunPlan& plan, const project::BoardDescription& board);

// Reads the scenario, and of the program what it runs on.  ScenarioError; ElfError;
// std::runtime_error: an option that this run has no use for, or no program for its processor.
RunPlan plan_run(RunDescription description);

}  // namespace sim
