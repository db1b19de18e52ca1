#include "sim/run/plan.h"

#include <stdexcept>

#include "sim/cpu/elf.h"
#include "sim/run/file_kind.h"
#include "sim/text/words.h"

namespace sim {

namespace {

constexpr unsigned DDR3_MB_PER_S = 3'200;  // of 32 bits at 400 MHz, both edges

Scenario scenario_of(const RunDescription& run) {
    if (run.scenario.empty()) return {};
    return run.scenario_text
               ? parse_scenario(*run.scenario_text, run.scenario)
               : load_scenario(run.scenario, run.outputs.update_goldens ? Goldens::MAY_BE_NEW
                                                                        : Goldens::ARE_THERE);
}

// As the ELF's machine decides.
RunPlan::Processor processor_for(const std::filesystem::path& elf, bool wants_arm,
                                 bool has_project) {
    refuse_no_program(elf);
    if (machine_of(elf) == ElfMachine::ARM) return RunPlan::Processor::ARM;
    const char* const why = wants_arm     ? "--cpu arm runs programs for the ARM"
                            : has_project ? "a project's system has the ARM"
                                          : nullptr;
    if (why)
        throw std::runtime_error{elf.string() + ": is for RISC-V (Nios V), but " + why +
                                 ": expected a program for the ARM"};
    return RunPlan::Processor::NIOS_V;
}

// Options that Nios V has, too.
bool is_for_all(const std::string& option) {
    return option == "--cpi" || option == "--no-shortcuts" || option == "--gdb" ||
           option == "--profile";
}

RunPlan::Processor processor_of(const ProgramDescription& program, const Scenario& scenario,
                                bool has_project) {
    using Processor = RunPlan::Processor;
    const bool has_program = !program.elf.empty();
    std::string cpu = program.cpu;
    if (cpu == "auto" && !has_project && !has_program) cpu = scenario.cpu;
    if (cpu == "native") return Processor::NATIVE;
    if (cpu == "arm" && !has_program)
        throw std::runtime_error{"--cpu: arm needs a program: --elf FILE"};
    if (has_program) return processor_for(program.elf, cpu == "arm", has_project);
    return has_project ? Processor::NONE : Processor::NATIVE;
}

// What the program is run on: --system, or for "auto" what the ELF expects.
bool runs_on_linux(const ProgramDescription& program) {
    return program.system == "linux" || (program.system == "auto" && expects_linux(program.elf));
}

void refuse_other_chips_options(const ChipDescription& chip, bool has_project) {
    if (!has_project && chip.ddr3_mb_per_s)
        throw std::runtime_error{
            "--ddr3-rate: is for a project's design: expected --project, or a scenario with a "
            "project"};
    const char* const ours = chip.bridged_memory ? "--fpga-memory"
                             : chip.audio_rate   ? "--audio-rate"
                                                 : nullptr;
    if (has_project && ours)
        throw std::runtime_error{
            std::string{ours} +
            ": is for the DE1-SoC Computer, which is built in: expected no project"};
}

// The board whose computer the program runs on, by its name; nothing: the DE1-SoC.
std::optional<project::BoardDescription> computer_of(const ChipDescription& chip,
                                                     RunPlan::Processor processor) {
    constexpr const char *PRESET = "DE1-SoC", *WITHOUT_ARM = "DE10-Lite";
    const auto boards = project::all_boards();
    const auto board = project::board_named(boards, chip.project.board);
    if (board.name == PRESET) return {};
    const std::string named = "board " + board.name + ": ";
    if (board.computer.empty()) {
        std::vector<std::string> names;
        for (const auto& other : boards)
            if (!other.computer.empty()) names.push_back(other.name);
        throw std::runtime_error{named + "no computer for it is built in: expected " +
                                 list_of(names) + ", or --project with a design for it"};
    }
    if (board.computer != WITHOUT_ARM) return board;
    if (processor != RunPlan::Processor::NIOS_V)
        throw std::runtime_error{named +
                                 "its computer has Nios V: expected a program for RISC-V, "
                                 "riscv64-unknown-elf-gcc -march=rv32im -mabi=ilp32"};
    if (chip.audio_rate)
        throw std::runtime_error{named + "it has no sound: expected no --audio-rate"};
    return board;
}

// Looks whether there is the board that is named, and finds it for a run without a project.
std::optional<project::BoardDescription> named_computer(const RunPlan& plan) {
    const ChipDescription& chip = plan.description.chip;
    if (chip.project.board.empty()) return {};
    if (!plan.has_project()) return computer_of(chip, plan.processor);
    project::board_named(project::all_boards(), chip.project.board);
    return {};
}

}  // namespace

std::string missing_for(const RunPlan& plan, const Step& step) {
    if (plan.on_linux || !step.needs_linux()) return "";
    return std::string{"expected a Linux program that gets the signal (--elf), got "} +
           (plan.has_program() ? "one without Linux" : "none");
}

void set_board(RunPlan& plan, const project::BoardDescription& board) {
    if (plan.processor == RunPlan::Processor::ARM && !board.has_processor)
        throw std::runtime_error{"--elf: the chip of the " + board.name +
                                 " has no processor to run it: expected no program"};
    if (plan.has_project() && plan.strictness == Monitor::Strictness::STRICT &&
        !board.has_wire("VGA_BLANK_N"))
        throw std::runtime_error{"--strict-vga: needs BLANK_N, which the " + board.name +
                                 " has not: expected no such option"};
    BoardParts& parts = plan.scenario.board;
    parts.name = board.name;
    for (const project::BoardSignal& signal : board.signals) {
        parts.wires.insert(signal.wires.begin(), signal.wires.end());
        const std::string& first = signal.wires.front();
        const std::string bus = first.substr(0, first.find('['));
        if (!bus.empty() && bus != signal.name) parts.names.emplace(bus, signal.name);
    }
    // The processor's I2C has the sensor where the FPGA has it not.
    if (board.has_processor) parts.wires.insert({"HPS", "MOTION"});
    if (board.has_lcd) parts.wires.insert("HPS LCD");
    if (board.has_wire("GSENSOR_CS_N")) parts.wires.insert("MOTION");
    for (unsigned n = 0; n < board.analog_inputs; ++n)
        parts.wires.insert("ANALOG[" + std::to_string(n) + "]");
    check_scenario(plan.scenario);
}

RunPlan plan_run(RunDescription description) {
    ChipDescription& chip = description.chip;
    ProgramDescription& program = description.program;
    Scenario scenario = scenario_of(description);
    if (chip.project.place.empty() && program.cpu != "native")
        chip.project.place = scenario.project;
    const bool has_project = !chip.project.place.empty();
    const bool names_its_board = chip.project.board.empty() && !scenario.board_name.empty();
    if (names_its_board) chip.project.board = scenario.board_name;
    refuse_other_chips_options(chip, has_project);
    if (program.elf.empty() && program.cpu != "native" &&
        (has_project || program.cpu == "arm" || scenario.cpu != "native"))
        program.elf = scenario.program;
    const RunPlan::Processor processor = processor_of(program, scenario, has_project);
    const bool is_arm = processor == RunPlan::Processor::ARM;
    for (const std::string& option : program.arm_options)
        if (!is_arm && !(processor == RunPlan::Processor::NIOS_V && is_for_all(option)))
            throw std::runtime_error{option + ": is for --cpu arm"};
    RunPlan plan;
    plan.processor = processor;
    plan.on_linux = is_arm && runs_on_linux(program);
    plan.seed = description.seed.value_or(scenario.seed);
    plan.duration = description.duration ? description.duration : scenario.duration;
    plan.bridged_memory = chip.bridged_memory.value_or(scenario.memory_bridged.value_or(false));
    plan.ddr3_mb_per_s = chip.ddr3_mb_per_s.value_or(DDR3_MB_PER_S);
    plan.audio_rate = chip.audio_rate.value_or(scenario.audio_rate.value_or(8'000));
    plan.strictness = chip.strict_vga.value_or(!has_project) ? Monitor::Strictness::STRICT
                                                             : Monitor::Strictness::TOLERANT;
    plan.description = std::move(description);
    plan.scenario = std::move(scenario);
    for (const ScenarioStep& step : plan.scenario.steps)
        if (const std::string missing = missing_for(plan, *step.step); !missing.empty())
            throw ScenarioError{plan.scenario.file, step.line, step.column, missing};
    plan.scenario.on_linux = plan.on_linux;
    try {
        plan.computer_of = named_computer(plan);
    } catch (const std::runtime_error& error) {
        if (!names_its_board) throw;
        throw ScenarioError{plan.scenario.file, plan.scenario.board_line,
                            plan.scenario.board_column, error.what()};
    }
    if (has_project)
        check_scenario(plan.scenario);  // its board is known when it has been read
    else
        set_board(plan, plan.computer_of ? *plan.computer_of : project::de1_soc());
    return plan;
}

}  // namespace sim
