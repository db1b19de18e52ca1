#include "sim/run/run.h"

#include <new>

#include <fmt/format.h>

#include "sim/board/board.h"
#include "sim/chip/computer.h"
#include "sim/chip/project_computer.h"
#include "sim/debug/debugger.h"
#include "sim/live/live_player.h"
#include "sim/play/scenario_runner.h"
#include "sim/process/interrupt.h"
#include "sim/report/messages.h"
#include "sim/report/report.h"
#include "sim/report/seconds.h"
#include "sim/report/trace_file.h"
#include "sim/run/arm_run.h"
#include "sim/run/crash_report.h"
#include "sim/run/progress.h"
#include "sim/run/recorder.h"
#include "sim/run/results.h"
#include "sim/run/run_again.h"
#include "sim/run/run_loop.h"
#include "sim/run/run_page.h"
#include "sim/run/trace_notes.h"
#include "sim/scenario/scenario.h"

namespace sim {

namespace {

// How the simulator itself failed.  SystemC wraps what a process throws.
std::string what_broke(const std::exception& error, const std::string& doing) {
    const auto* wrapped = dynamic_cast<const sc_core::sc_report*>(&error);
    const std::string what = wrapped ? wrapped->get_msg() : error.what();
    if (what == std::bad_alloc{}.what()) return "out of memory while " + doing;
    return "internal error while " + doing + ": " + what;
}

// Carries out the parts of a run that has begun.  One that fails is written down and the others
// still come; only an IoError ends them all.
class GuardedSteps {
public:
    template <class Part>
    void carry_out(const char* doing, Part part) {
        try {
            part();
        } catch (const IoError&) {
            throw;
        } catch (const std::exception& error) {
            const double now_s = seconds(sc_core::sc_time_stamp());
            failures.push_back(what_broke(error, fmt::format("{}, at {:.6f} s", doing, now_s)));
        }
    }

    std::vector<std::string> failures;
};

ExitCode exit_code(const RunReport& report) {
    switch (report.end) {
        case RunEnd::INTERRUPTED: return INTERRUPTED;
        case RunEnd::DESIGN_OSCILLATES:
        case RunEnd::INTERNAL_ERROR: return WRONG_INPUT;
        default: return report.passed() ? PASSED : FAILED;
    }
}

// Where a project's own files are.
std::string project_folder_of(const std::filesystem::path& place) {
    const auto whole = std::filesystem::absolute(place);
    return (std::filesystem::is_directory(whole) ? whole : whole.parent_path()).string();
}

// std::runtime_error: the project has none.
const project::qsys::Generated& processor_system_of(const project::Built& built) {
    for (const auto& system : built.systems)
        if (system.has_processor) return system;
    throw std::runtime_error{
        "--elf: the project has no processor to run it: expected a Platform Designer system "
        "(.qsys) with a Hard Processor System in it"};
}

Scenario scenario_of(const RunOptions& options) {
    if (options.scenario.empty()) return {};
    return options.scenario_text
               ? parse_scenario(*options.scenario_text, options.scenario)
               : load_scenario(options.scenario,
                               options.update_goldens ? Goldens::MAY_BE_NEW : Goldens::ARE_THERE);
}

// `doing` is what a message says when it throws.
ExitCode run_doing(const char*& doing, RunOptions options, const Firmware& firmware) {
    doing = "reading the scenario";
    const Scenario scenario = scenario_of(options);
    settle_by_scenario(options, scenario);
    const std::uint64_t seed = options.seed.value_or(scenario.seed);
    const std::optional<SimTime> duration = options.duration ? options.duration : scenario.duration;

    doing = "loading the program";
    Computer::Software software = firmware;
    const bool on_linux = options.cpu == "arm" && runs_on_linux(options);
    if (options.cpu == "arm") software = load_program(options, on_linux);

    doing = "setting up the board";
    std::optional<GdbConnection> gdb;
    if (options.gdb) gdb.emplace(*options.gdb);

    note_interrupts();
    Recorder recorder{options.out, options.frames, options.video};
    std::optional<ProgramOutput> output;
    if (!options.quiet) recorder.output = &output.emplace(options.gdb.has_value());
    std::optional<RunPage> page;
    if (!options.html.empty()) page.emplace(options, recorder);
    std::optional<TraceFile> trace;
    if (!options.trace.empty()) trace.emplace(options.trace);
    const Computer::Settings settings{
        seed,
        {trace ? trace->part().string() : "", options.trace_from ? options.trace_from->ps : 0,
         options.trace_to ? options.trace_to->ps : MAX_SIM_TIME.ps},
        *options.memory == "bridge" ? Fpga::Memory::BRIDGED : Fpga::Memory::MAPPED,
        *options.audio_rate,
        options.shortcuts};
    std::optional<project::Built> built;
    if (!options.project.place.empty()) {
        doing = "building the project";
        built = build_with_progress(options.project, !options.trace.empty(), options.quiet);
        doing = "setting up the board";
    }
    const std::string project_folder = built ? project_folder_of(options.project.place) : "";
    std::optional<live::Wire> wire;
    std::optional<live::LiveView> view;
    if (options.live_socket) {
        wire.emplace(*options.live_socket);
        view.emplace(recorder, *wire);
    }
    BoardObserver& observer = view ? static_cast<BoardObserver&>(*view) : recorder;
    ProcessorSystem* processor = nullptr;
    Computer* computer = nullptr;  // where the chip has this project's own fabric
    Board board{"board",
                observer,
                seed,
                scenario.ps2,
                [&](PinListener& pins, BoardObserver& listener,
                    std::uint8_t* sdram) -> std::unique_ptr<Chip> {
                    if (built && options.cpu == "arm") {
                        auto chip = std::make_unique<ProjectComputer>(
                            "computer", pins, listener, std::move(software), built->library,
                            project_folder, settings.trace, processor_system_of(*built));
                        processor = chip.get();
                        return chip;
                    }
                    if (built)
                        return std::make_unique<ProjectChip>("chip", pins, built->library,
                                                             project_folder, settings.trace);
                    auto chip = std::make_unique<Computer>("computer", pins, listener, sdram,
                                                           std::move(software), settings);
                    processor = computer = chip.get();
                    return chip;
                },
                options.strict_vga.value_or(!built) ? Monitor::Strictness::STRICT
                                                    : Monitor::Strictness::TOLERANT,
                scenario.parts};
    std::optional<ArmRun> arm;
    if (processor && processor->arm)
        arm.emplace(*processor->arm, processor->bus, &board.accelerometer, options, on_linux,
                    recorder, observer);
    std::optional<TraceNotes> notes;
    if (processor && traces_a_part(options))
        notes.emplace(*processor, arm ? &*arm : nullptr, options);
    if (arm) board.also_type_to([&arm](const std::string& text) { arm->type(text); });
    if (arm) arm->plug_in(board.ps2_keyboard, board.ps2_mouse);
    if (arm && options.scenario.empty() && !view) arm->close_input();  // there is nobody to type
    ScenarioRunner runner{"runner", board, recorder.observations(), scenario.steps, options.out};
    runner.renews_goldens = options.update_goldens;
    if (page) runner.on_step = [&page] { page->step_done(); };
    std::optional<live::LivePlayer> live_player;
    std::optional<live::Inside> inside;
    if (view) {
        const auto program = [&arm] {
            const auto& frames = arm->frames();
            return live::Inside::Program{
                arm->waiting(), frames.empty() ? std::nullopt : std::optional{frames.back()}};
        };
        inside.emplace(board, processor, computer ? &computer->fpga : nullptr,
                       arm ? program : std::function<live::Inside::Program()>{});
        view->on_frame = [&inside] { inside->frame_ended(); };
        runner.on_terminal = [&view](const std::string& part, char byte) {
            view->terminal(part, byte);
        };
        board.parts.for_each_terminal(
            [&view](const std::string& part, SerialTerminal&) { view->add_terminal(part); });
        live_player.emplace("live_player", runner, *view, *inside, *wire, scenario, seed, options);
    }
    const sc_core::sc_event never;
    Finish finish{"finish", runner.done(), processor ? processor->cpu.faulted() : never};

    std::optional<Debugger> debugger;
    if (gdb) debugger.emplace(*processor->arm, *gdb, interrupted);

    Progress progress{options.quiet,
                      duration ? std::optional<double>{seconds(duration->ps)} : std::nullopt};
    if (gdb) message(fmt::format("waiting for gdb at 127.0.0.1:{}", gdb->port()));

    RunReport report;
    report.scenario = scenario.name;
    report.file = scenario.file.string();
    report.seed = seed;
    report.cpu = options.cpu;
    CrashReport crash_report{options.out, report};
    GuardedSteps parts;
    parts.carry_out("simulating", [&] {
        report.end = RunLoop{board,
                             processor,
                             runner,
                             recorder,
                             duration,
                             options.scenario.empty(),
                             progress,
                             debugger ? &*debugger : nullptr,
                             live_player ? &*live_player : nullptr,
                             crash_report}
                         .run();
        report.simulated_s = seconds(sc_core::sc_time_stamp());
        if (processor && processor->arm) processor->arm->conclude();
        if (processor) processor->close_bridges();
        while (processor && processor->is_accessing())
            sc_core::sc_start(sc_core::sc_time{1, sc_core::SC_US});
        board.chip().catch_up();
    });
    progress.done();
    if (output) output->end();
    report.wall_s = progress.wall_s();
    parts.carry_out("writing pictures, sound and console", [&] { recorder.close(); });
    if (arm) parts.carry_out("writing the profile", [&] { arm->write_profile(); });
    if (trace)
        parts.carry_out("writing the waveforms", [&] {
            board.chip().end_trace();
            trace->commit(traces_a_part(options));
            if (notes) notes->write();
        });
    parts.carry_out("writing the report", [&] {
        add_results(report, board, processor, computer, arm ? &*arm : nullptr, runner, recorder);
    });
    if (view) view->end(report.faults);
    if (!parts.failures.empty()) report.end = RunEnd::INTERNAL_ERROR;
    if (const auto ended = board.chip().end(); ended && ended->kind != Chip::End::Kind::FINISHED)
        report.faults.push_back(ended->message);
    else if (ended && !options.quiet)
        message(ended->message);
    report.faults.insert(report.faults.begin(), parts.failures.begin(), parts.failures.end());

    if (options.trace_failure && !report.passed() && !interrupted()) {
        doing = "running again for waveforms";
        trace_failure(options, report, interrupted);
    }

    doing = "writing the report";
    write_whole_file(options.out / "report.json", to_json(report));
    write_whole_file(options.out / "junit.xml", to_junit(report));
    if (page) page->write(report, scenario, runner, arm ? &*arm : nullptr);
    ExitCode code = exit_code(report);
    if ((!options.quiet || !report.passed()) && !summarise(report, options.out) && code == PASSED)
        code = WRONG_INPUT;
    if (debugger) debugger->ended(code);
    return code;
}

}  // namespace

ExitCode run(const RunOptions& options, const Firmware& firmware) {
    const char* doing = "";
    try {
        return run_doing(doing, options, firmware);
    } catch (const ScenarioError& e) {
        message(e.what());
    } catch (const std::bad_alloc&) {
        complain(std::string{"out of memory while "} + doing);
    } catch (const std::exception& e) {  // IoError, an ELF that is none
        complain(e.what());
    }
    return WRONG_INPUT;
}

}  // namespace sim
