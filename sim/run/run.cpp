#include "sim/run/run.h"

#include <csignal>

#include <fmt/format.h>

#include "regmap.h"
#include "sim/board/board.h"
#include "sim/debug/debugger.h"
#include "sim/report/printable.h"
#include "sim/report/report.h"
#include "sim/report/sha256.h"
#include "sim/report/trace_file.h"
#include "sim/run/arm_run.h"
#include "sim/run/progress.h"
#include "sim/run/recorder.h"
#include "sim/scenario/player.h"
#include "sim/scenario/scenario.h"

namespace sim {

namespace {

volatile std::sig_atomic_t interrupted = 0;  // a signal handler can reach nothing else

void on_interrupt(int) { interrupted = 1; }

// Ends sc_start when the steps are done (unless a duration says when) or the firmware has faulted.
class Finish : public sc_core::sc_module {
public:
    Finish(const sc_core::sc_module_name& name, const sc_core::sc_event& done,
           const sc_core::sc_event& faulted)
        : sc_module{name} {
        SC_HAS_PROCESS(Finish);
        SC_METHOD(pause);
        sensitive << done << faulted;
        dont_initialize();
    }

private:
    void pause() { sc_core::sc_pause(); }
};

std::uint64_t underruns(Board& board) {
    return board.fpga.peek(regmap::CODEC_UNDERRUNS - 0xFF200000).value_or(0);
}

RunEnd play(Board& board, Player& player, Recorder& recorder, std::optional<SimTime> duration,
            Progress& progress, Debugger* debugger) {
    const sc_core::sc_time slice{1, sc_core::SC_MS};
    const sc_core::sc_time end =
        duration ? sc_core::sc_time::from_value(duration->ps) : sc_core::sc_max_time();
    for (;;) {
        if (debugger) debugger->poll();
        if (interrupted || (debugger && debugger->killed())) return RunEnd::INTERRUPTED;
        if (recorder.error()) return RunEnd::INTERRUPTED;
        if (board.cpu.fault()) return RunEnd::FIRMWARE_FAULT;
        if (!duration && player.finished()) return RunEnd::ALL_STEPS_DONE;
        const sc_core::sc_time now = sc_core::sc_time_stamp();
        if (now >= end)
            return player.finished() ? RunEnd::ALL_STEPS_DONE : RunEnd::DURATION_REACHED;
        sc_core::sc_start(std::min(slice, end - now));
        progress.show(sc_core::sc_time_stamp().to_seconds(), board.monitor.frames());
    }
}

RunReport report_of(const Scenario& scenario, const RunOptions& options, std::uint64_t seed,
                    RunEnd end, Board& board, const ArmRun* arm, const Player& player,
                    Recorder& recorder, double wall_s) {
    RunReport report;
    report.scenario = scenario.name;
    report.file = scenario.file.string();
    report.seed = seed;
    report.cpu = options.cpu;
    if (arm) report.program = arm->program();
    report.end = end;
    report.simulated_s = sc_core::sc_time_stamp().to_seconds();
    report.wall_s = wall_s;
    report.frames_shown = board.monitor.frames();
    report.frames_swapped = board.monitor.new_pictures();
    if (report.frames_shown > 0)
        report.last_frame_sha256 = sha256_hex(recorder.senses().picture().rgb);
    const BusCounts& bus = board.bus.counts();
    report.bus = {bus.reads, bus.writes, bus.bursts, bus.errors};
    report.audio = {recorder.senses().rate_hz, recorder.senses().samples, underruns(board)};
    report.key_events = board.keypad.presses() + board.keypad.releases();
    report.timing_violation_count = board.monitor.violations();
    report.timing_violations = board.monitor.messages();
    if (board.cpu.fault()) report.faults.push_back(*board.cpu.fault());
    for (const std::string& fault : board.codec_chip.errors()) report.faults.push_back(fault);
    for (const std::string& fault : player.faults()) report.faults.push_back(fault);
    report.log_lines = recorder.log_lines();
    report.log = recorder.log();
    report.expectations = player.results();
    report.checks = tap_checks(recorder.senses().text);
    return report;
}

void summarise(const RunReport& report, const std::filesystem::path& out) {
    std::size_t met = 0;
    for (const Expectation& e : report.expectations) {
        met += e.met;
        if (!e.met)
            fmt::print(stderr, "{}:{}: {}: not met: {}\n", report.file, e.line, e.step, e.detail);
    }
    for (const Check& check : report.checks) {
        met += check.met;
        if (!check.met)
            fmt::print(stderr, "{}: not met: {}\n", printable(check.name), printable(check.detail));
    }
    for (const std::string& fault : report.faults) fmt::print(stderr, "de1sim: {}\n", fault);
    if (report.program && report.end == RunEnd::DURATION_REACHED) {
        const RunReport::Program& p = *report.program;
        fmt::print(stderr, "de1sim: the program was at PC 0x{:08X}{}{}{}{}\n", p.pc,
                   p.function.empty() ? "" : " in ", p.function,
                   p.waiting.empty() ? "" : ", waiting for ", p.waiting);
    }
    if (report.timing_violation_count)
        fmt::print(stderr, "de1sim: {} VGA timing violations; {}\n", report.timing_violation_count,
                   report.timing_violations.front());
    if (report.frames_shown == 0)
        fmt::print(stderr, "de1sim: the monitor found no picture\n");
    else if (report.frames_shown > 1 && report.frames_swapped == 1)
        fmt::print(stderr, "de1sim: the picture never changed: the firmware did not swap\n");
    fmt::print(
        "{}: {}; {:.3f} s simulated in {:.2f} s, {} frames ({} new pictures), "
        "{} of {} {} met; see {}\n",
        report.scenario, to_string(report.end), report.simulated_s, report.wall_s,
        report.frames_shown, report.frames_swapped, met,
        report.expectations.size() + report.checks.size(),
        report.checks.empty() ? "expectations" : "expectations and checks", out.string());
}

}  // namespace

ExitCode run(const RunOptions& options, const Firmware& firmware) try {
    const Scenario scenario = options.scenario_text
                                  ? parse_scenario(*options.scenario_text, options.scenario)
                                  : load_scenario(options.scenario);
    const std::uint64_t seed = options.seed.value_or(scenario.seed);
    const std::optional<SimTime> duration = options.duration ? options.duration : scenario.duration;

    Board::Software software = firmware;
    const bool on_linux = options.cpu == "arm" && runs_on_linux(options);
    if (options.cpu == "arm") software = load_program(options, on_linux);

    std::optional<GdbConnection> gdb;
    if (options.gdb) gdb.emplace(*options.gdb);

    Recorder recorder{options.out, options.frames};
    std::optional<TraceFile> trace;
    if (!options.trace.empty()) trace.emplace(options.trace);
    Board board{"board", recorder, std::move(software), seed, trace ? trace->part().string() : ""};
    std::optional<ArmRun> arm;
    if (board.arm) arm.emplace(*board.arm, options, on_linux, recorder);
    Player player{"player", board, recorder.senses(), scenario.steps, options.out};
    Finish finish{"finish", player.done(), board.cpu.faulted()};

    std::optional<Debugger> debugger;
    if (gdb) debugger.emplace(*board.arm, *gdb, [] { return interrupted != 0; });

    std::signal(SIGINT, on_interrupt);
    std::signal(SIGTERM, on_interrupt);
    std::signal(SIGXFSZ, SIG_IGN);  // a file too large is an error like a full disk
    Progress progress{
        options.quiet,
        duration ? std::optional<double>{static_cast<double>(duration->ps) * 1e-12} : std::nullopt};
    if (gdb) fmt::print(stderr, "waiting for gdb at 127.0.0.1:{}\n", gdb->port());
    const RunEnd end =
        play(board, player, recorder, duration, progress, debugger ? &*debugger : nullptr);
    progress.done();
    board.fpga.catch_up();
    recorder.close();
    if (arm) arm->write_profile();
    if (trace) {
        board.fpga.end_trace();
        trace->commit();
    }

    const RunReport report = report_of(scenario, options, seed, end, board, arm ? &*arm : nullptr,
                                       player, recorder, progress.wall_s());
    write_whole_file(options.out / "report.json", to_json(report));
    write_whole_file(options.out / "junit.xml", to_junit(report));
    if (!options.quiet || !report.passed()) summarise(report, options.out);
    const ExitCode code = end == RunEnd::INTERRUPTED ? INTERRUPTED
                          : report.passed()          ? PASSED
                                                     : FAILED;
    if (debugger) debugger->ended(code);
    return code;
} catch (const ScenarioError& e) {
    fmt::print(stderr, "{}\n", e.what());
    return WRONG_INPUT;
} catch (const std::exception& e) {  // IoError, a trace file that cannot be opened
    fmt::print(stderr, "de1sim: {}\n", e.what());
    return WRONG_INPUT;
}

}  // namespace sim
