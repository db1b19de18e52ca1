#include "sim/run/session.h"

#include <new>
#include <stdexcept>

#include <fmt/format.h>

#include "sim/chip/de10_lite_computer.h"
#include "sim/chip/project_computer.h"
#include "sim/debug/arm_debugger.h"
#include "sim/debug/nios_v_debugger.h"
#include "sim/files/whole_file.h"
#include "sim/process/interrupt.h"
#include "sim/run/results.h"
#include "sim/run/run_again.h"
#include "sim/text/messages.h"
#include "sim/text/seconds.h"

namespace sim {

namespace {

// What `part` returns.  std::runtime_error in place of std::bad_alloc, which says nothing.
template <class Part>
auto during(const char* doing, Part part) {
    try {
        return part();
    } catch (const std::bad_alloc&) {
        throw std::runtime_error{std::string{"out of memory while "} + doing};
    }
}

// How the simulator itself failed.  SystemC wraps what a process throws.
std::string what_broke(const std::exception& error, const std::string& doing) {
    const auto* wrapped = dynamic_cast<const sc_core::sc_report*>(&error);
    const std::string what = wrapped ? wrapped->get_msg() : error.what();
    if (what == std::bad_alloc{}.what()) return "out of memory while " + doing;
    return "internal error while " + doing + ": " + what;
}

// Where a project's own files are.
std::string project_folder_of(const std::filesystem::path& place) {
    const auto whole = std::filesystem::absolute(place);
    return (std::filesystem::is_directory(whole) ? whole : whole.parent_path()).string();
}

const project::qsys::Generated& processor_system_of(const project::Built& built) {
    for (const auto& system : built.systems)
        if (system.has_processor) return system;
    throw std::runtime_error{
        "--elf: the project has no processor to run it: expected a Platform Designer system "
        "(.qsys) with a Hard Processor System in it, or the device's primitives in the Verilog "
        "(cyclonev_hps_interface_hps2fpga_light_weight and others)"};
}

std::optional<GdbConnection> listening_for_gdb(const RunOutputs& outputs) {
    if (!outputs.gdb) return std::nullopt;
    return std::optional<GdbConnection>{std::in_place, *outputs.gdb};
}

// What the scenario needs is looked for on the board before the design is compiled.
std::optional<project::Built> built_project(RunPlan& plan) {
    if (!plan.has_project()) return {};
    const RunOutputs& outputs = plan.description.outputs;
    return during("building the project", [&] {
        return build_with_progress(
            plan.description.chip.project, !outputs.trace.file.empty(), outputs.quiet,
            [&](const project::BoardDescription& board) { set_board(plan, board); });
    });
}

Software software_for(const RunPlan& plan, const Firmware& firmware) {
    if (!plan.has_program()) return firmware;
    return during("loading the program", [&]() -> Software {
        if (plan.processor == RunPlan::Processor::NIOS_V) return load_nios_v_program(plan);
        return load_program(plan);
    });
}

// Not for Nios V.
ProcessorSystem::Software hps_software(Software software) {
    if (auto* firmware = std::get_if<Firmware>(&software)) return std::move(*firmware);
    return std::get<ArmProgram>(std::move(software));
}

ExitCode exit_code(const RunReport& report) {
    switch (report.end) {
        case RunEnd::INTERRUPTED: return INTERRUPTED;
        case RunEnd::DESIGN_OSCILLATES:
        case RunEnd::INTERNAL_ERROR: return WRONG_INPUT;
        default: return report.passed() ? PASSED : FAILED;
    }
}

BoardShape shape_of(const RunPlan& plan, const std::optional<project::Built>& built) {
    if (!built && !plan.computer_of) return {};
    const project::BoardDescription& board = built ? built->board : *plan.computer_of;
    BoardShape shape;
    shape.on_i2c = board.on_i2c;
    shape.has_blank = !built || board.has_wire("VGA_BLANK_N");
    shape.hears_gsensor = !built && board.has_wire("GSENSOR_CS_N");
    shape.has_lcd = board.has_lcd;
    shape.has_arduino = board.has_wire("ARDUINO_IO[0]");
    return shape;
}

RunReport begun_report(const RunPlan& plan) {
    RunReport report;
    report.scenario = plan.scenario.name;
    report.file = plan.scenario.file.string();
    report.seed = plan.seed;
    report.cpu = plan.cpu();
    return report;
}

}  // namespace

Observers::Observers(const RunPlan& plan, const RunClientMaker& make_client)
    : recorder{plan.description.outputs.out, plan.description.outputs.frames,
               plan.description.outputs.video} {
    const RunOutputs& outputs = plan.description.outputs;
    if (!outputs.quiet) recorder.output = &output.emplace(outputs.gdb.has_value());
    if (!outputs.html.empty()) page.emplace(plan.description, recorder);
    if (!outputs.trace.file.empty()) trace.emplace(outputs.trace.file);
    if (outputs.live_socket) client = make_client(*outputs.live_socket, recorder);
}

System::System(const RunPlan& plan, Software software, const std::optional<project::Built>& built,
               Observers& observers)
    : board{"board",
            observers.all(),
            plan.seed,
            plan.scenario.ps2,
            [&](PinListener& pins, ChipObserver& observer, std::uint8_t* sdram) {
                return chip_for(plan, std::move(software), built,
                                observers.trace ? observers.trace->part().string() : "", pins,
                                observer, sdram);
            },
            plan.strictness,
            plan.scenario.parts,
            plan.scenario.usb,
            shape_of(plan, built)},
      runner{"runner", board, observers.recorder.observations(), plan.scenario.steps,
             plan.description.outputs.out} {
    const RunOutputs& outputs = plan.description.outputs;
    if (hps && hps->arm) {
        arm.emplace(*hps, dynamic_cast<Computer*>(hps), &board.accelerometer, plan,
                    observers.recorder, observers.all());
        board.also_type_to([this](const std::string& text) { arm->type(text); });
        if (arm->on_linux()) board.parts.add("Linux program", *arm);
        arm->plug_in(board.usb);
        const bool nobody_types = plan.description.scenario.empty() && !observers.client;
        if (nobody_types) arm->close_input();
    }
    if (nios_v_computer) nios_v.emplace(*nios_v_computer, plan, observers.recorder);
    if (processor && outputs.trace.is_of_a_part())
        trace_notes.emplace(*processor, program_run(), outputs.trace);
    runner.renews_goldens = outputs.update_goldens;
    if (observers.page) runner.on_step = [&observers] { observers.page->step_done(); };
    if (observers.client)
        observers.client->attach({plan, board, processor, fabric, program_run(), runner});
}

std::unique_ptr<Chip> System::chip_for(const RunPlan& plan, Software software,
                                       const std::optional<project::Built>& built,
                                       const std::string& trace_part, PinListener& pins,
                                       ChipObserver& observer, std::uint8_t* sdram) {
    const RunDescription& run = plan.description;
    const TraceDescription& part = run.outputs.trace;
    const Trace trace{trace_part, part.from ? part.from->ps : 0,
                      part.to ? part.to->ps : MAX_SIM_TIME.ps};
    if (!built) {
        const Computer::Settings settings{
            plan.seed,
            trace,
            plan.bridged_memory ? Fabric::Memory::BRIDGED : Fabric::Memory::MAPPED,
            plan.audio_rate,
            run.program.shortcuts,
            !plan.computer_of || plan.computer_of->has_wire("GPIO_1[0]")};
        if (auto* program = std::get_if<NiosVProgram>(&software)) {
            std::unique_ptr<NiosVComputer> chip;
            if (plan.computer_of && plan.computer_of->computer == "DE10-Lite")
                chip = std::make_unique<De10LiteComputer>("computer", pins, observer, sdram,
                                                          std::move(*program), settings);
            else
                chip = std::make_unique<NiosVComputer>("computer", pins, observer, sdram,
                                                       std::move(*program), settings);
            processor = nios_v_computer = chip.get();
            fabric = chip.get();
            return chip;
        }
        auto chip = std::make_unique<Computer>("computer", pins, observer, sdram,
                                               hps_software(std::move(software)), settings);
        processor = hps = chip.get();
        fabric = chip.get();
        return chip;
    }
    const std::string folder = project_folder_of(run.chip.project.place);
    if (plan.processor != RunPlan::Processor::ARM)
        return std::make_unique<ProjectChip>(pins, built->library, folder, trace);
    auto chip = std::make_unique<ProjectComputer>(
        "computer", pins, observer, hps_software(std::move(software)), built->library, folder,
        trace, processor_system_of(*built), plan.ddr3_mb_per_s);
    processor = hps = chip.get();
    return chip;
}

Session::Session(RunPlan plan, const Firmware& firmware, const RunClientMaker& make_client)
    : plan_{std::move(plan)},
      software_{software_for(plan_, firmware)},
      gdb_{listening_for_gdb(plan_.description.outputs)},
      observers_{plan_, make_client},
      built_{built_project(plan_)},
      system_{plan_, std::move(software_), built_, observers_},
      finish_{"finish", system_.runner.done(),
              system_.processor ? system_.processor->processor().faulted() : never_},
      progress_{plan_.description.outputs.quiet,
                plan_.duration ? std::optional<double>{seconds(plan_.duration->ps)} : std::nullopt},
      report_{begun_report(plan_)},
      crash_report_{plan_.description.outputs.out, report_} {
    if (gdb_) {
        debugger_ = debugger();
        message(fmt::format("waiting for gdb at 127.0.0.1:{}", gdb_->port()));
    }
}

std::unique_ptr<Debugger> Session::debugger() {
    if (NiosVComputer* const computer = system_.nios_v_computer)
        return std::make_unique<NiosVDebugger>(computer->cpu, *gdb_, interrupted);
    return std::make_unique<ArmDebugger>(*system_.hps->arm, *gdb_, interrupted);
}

// A part of the run that fails is written down, and the others still come; only an IoError ends
// them all.
template <class Part>
void Session::carry_out(const char* doing, Part part) {
    try {
        part();
    } catch (const IoError&) {
        throw;
    } catch (const std::exception& error) {
        const double now_s = seconds(sc_core::sc_time_stamp());
        failures_.push_back(what_broke(error, fmt::format("{}, at {:.6f} s", doing, now_s)));
    }
}

void Session::simulate() {
    System& s = system_;
    report_.end = RunLoop{s.board,
                          s.processor,
                          s.runner,
                          observers_.recorder,
                          plan_.duration,
                          plan_.description.scenario.empty(),
                          progress_,
                          debugger_.get(),
                          observers_.client.get(),
                          crash_report_}
                      .run();
    report_.simulated_s = seconds(sc_core::sc_time_stamp());
    if (s.processor && s.processor->program_cpu()) s.processor->program_cpu()->conclude();
    if (s.processor) s.processor->close_bridges();
    while (s.processor && s.processor->is_accessing())
        sc_core::sc_start(sc_core::sc_time{1, sc_core::SC_US});
    s.board.chip().catch_up();
}

void Session::write_files() {
    System& s = system_;
    carry_out("writing pictures, sound and console", [&] { observers_.recorder.close(); });
    if (ProgramRun* const run = s.program_run())
        carry_out("writing the profile", [&] { run->write_profile(); });
    carry_out("writing the kernel's messages", [&] {
        const auto file = plan_.description.outputs.out / "dmesg.txt";
        const std::string messages = s.arm ? s.arm->kernel_messages() : "";
        if (messages.empty())
            std::filesystem::remove(file);  // an earlier run's
        else
            write_whole_file(file, messages);
    });
    if (observers_.trace)
        carry_out("writing the waveforms", [&] {
            s.board.chip().end_trace();
            observers_.trace->commit(plan_.description.outputs.trace.is_of_a_part());
            if (s.trace_notes) s.trace_notes->write();
        });
}

// How it ended, in the report.
void Session::conclude() {
    const RunDescription& run = plan_.description;
    carry_out("writing the report", [&] {
        add_results(report_, system_.board, system_.processor, system_.fabric,
                    system_.program_run(), system_.runner, observers_.recorder);
    });
    if (observers_.client) observers_.client->end(report_.faults);
    if (!failures_.empty()) report_.end = RunEnd::INTERNAL_ERROR;
    if (const auto ended = system_.board.chip().end();
        ended && ended->kind != Chip::End::Kind::FINISHED)
        report_.faults.push_back(ended->message);
    else if (ended && !run.outputs.quiet)
        message(ended->message);
    report_.faults.insert(report_.faults.begin(), failures_.begin(), failures_.end());

    if (run.outputs.trace_failure && !report_.passed() && !interrupted())
        during("running again for waveforms", [&] { trace_failure(run, report_, interrupted); });
}

ExitCode Session::write_report() {
    const RunOutputs& outputs = plan_.description.outputs;
    write_whole_file(outputs.out / "report.json", to_json(report_));
    write_whole_file(outputs.out / "junit.xml", to_junit(report_));
    if (observers_.page)
        observers_.page->write(report_, plan_.scenario, system_.runner, system_.program_run());
    const ExitCode code = exit_code(report_);
    const bool shown = (outputs.quiet && report_.passed()) || summarise(report_, outputs.out);
    return !shown && code == PASSED ? WRONG_INPUT : code;
}

ExitCode Session::run() {
    carry_out("simulating", [this] { simulate(); });
    progress_.done();
    if (observers_.output) observers_.output->end();
    report_.wall_s = progress_.wall_s();
    write_files();
    conclude();
    const ExitCode code = during("writing the report", [this] { return write_report(); });
    if (debugger_) debugger_->ended(code);
    return code;
}

}  // namespace sim
