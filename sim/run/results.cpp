// results.cpp - see results.h
#include "sim/run/results.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <optional>
#include <vector>

#include "regmap.h"
#include "sim/chip/processor_system.h"
#include "sim/files/sha256.h"
#include "sim/hps/bridge_windows.h"
#include "sim/report/tap.h"
#include "sim/text/messages.h"
#include "sim/text/printable.h"

namespace sim {

namespace {

std::uint64_t underruns(ComputerFabric& computer) {
    return computer.bridges.peek(regmap::CODEC_UNDERRUNS - LW_BASE).value_or(0);
}

constexpr double FIRST_FRAMES_S = 0.034;  // the first is whole where the second begins

// The program has given the display something to show: a picture, or a place for one.
bool has_drawn(ComputerFabric& computer) {
    const auto holds = [&computer](std::uint32_t address, std::uint32_t value) {
        return computer.bridges.peek(address - LW_BASE).value_or(value) == value;
    };
    const auto has_pixels = [&fabric = computer.fabric] {
        std::vector<std::uint8_t> bytes(regmap::ONCHIP_SIZE);
        fabric.read_onchip(0, bytes.data(), regmap::ONCHIP_SIZE);
        return std::any_of(bytes.begin(), bytes.end(), [](std::uint8_t byte) { return byte != 0; });
    };
    return (computer.has_written_memory() && (!computer.fabric.has_memory() || has_pixels())) ||
           !holds(regmap::PIXEL_BUFFER, regmap::ONCHIP_BASE) ||
           !holds(regmap::PIXEL_BACK_BUFFER, regmap::ONCHIP_BASE);
}

// The address of one of the pixel controller's pictures, if that lies in the DDR3 memory.  The
// controller does not keep bits 31 and 30.  So an address in its own memories may be meant as one
// in the DDR3: it is, if the program has written nothing through the full bridge.
std::optional<std::uint32_t> picture_in_ddr3(ComputerFabric& computer) {
    constexpr std::uint32_t DDR3_SIZE = ProcessorSystem::DDR3_SIZE;
    constexpr std::uint32_t ONCHIP = regmap::ONCHIP_BASE % DDR3_SIZE;
    for (const std::uint32_t reg : {regmap::PIXEL_BUFFER, regmap::PIXEL_BACK_BUFFER}) {
        const auto value = computer.bridges.peek(reg - LW_BASE);
        if (!value) continue;
        const std::uint32_t address = *value % DDR3_SIZE;
        const bool in_sdram = address < regmap::SDRAM_SIZE;
        if (address - ONCHIP < regmap::ONCHIP_SIZE) continue;
        if (!in_sdram || !computer.has_written_memory()) return address;
    }
    return std::nullopt;
}

// A row of characters without the blanks at its end; what is no letter in ASCII is "?".
std::string text_of(std::string row) {
    for (char& c : row)
        if (c == 0)
            c = ' ';
        else if (c < ' ' || c > '~')
            c = '?';
    return row.substr(0, row.find_last_not_of(' ') + 1);
}

// What is seen besides pictures, a line each.
std::string seen(const RunReport& report) {
    constexpr unsigned MOST = 10;
    std::string text = report.lamps.empty() ? "" : report.lamps + "\n";
    for (const PartReport& part : report.parts) {
        if (part.rows.size() == 1)
            text += fmt::format("{} {}\n", part.name, part.rows[0]);
        else if (!part.rows.empty())
            text += fmt::format("{}\n  | {}\n", part.name, fmt::join(part.rows, "\n  | "));
        if (part.received)
            text += fmt::format("{} received {} characters\n", part.name, part.received->size());
    }
    unsigned rows = 0;
    for (const std::string& row : report.characters)
        if (!row.empty() && ++rows <= MOST) text += "  | " + row + "\n";
    if (rows > MOST) text += fmt::format("  and {} more rows of characters\n", rows - MOST);
    return text;
}

// The program may be waiting for something that does not come.
bool waits_in_vain(const RunReport& report) {
    if (!report.program || report.end == RunEnd::FIRMWARE_FAULT) return false;
    const auto& all = report.expectations;
    return report.end == RunEnd::DURATION_REACHED || report.end == RunEnd::INTERRUPTED ||
           std::any_of(all.begin(), all.end(), [](const Expectation& e) { return !e.met; });
}

// The program was shown to do what it should: all that was expected came, or it ended itself with
// 0.
bool succeeds(const RunReport& report) {
    const auto& all = report.expectations;
    if (!all.empty())
        return std::all_of(all.begin(), all.end(), [](const Expectation& e) { return e.met; });
    return report.program && report.program->exit_code == 0;
}

// The scenario's, or the program's where there is none.
std::string name_of(const RunReport& report) {
    if (!report.scenario.empty() || !report.program) return report.scenario;
    return std::filesystem::path{report.program->elf}.filename().string();
}

}  // namespace

void add_results(RunReport& report, Board& board, ProgramSystem* processor,
                 ComputerFabric* computer, ProgramRun* program, const ScenarioRunner& runner,
                 Recorder& recorder) {
    if (processor && processor->processor().fault())
        report.faults.push_back(*processor->processor().fault());
    else if (const auto fault = processor ? processor->processor().unfinished() : std::nullopt)
        report.faults.push_back(*fault);
    // Boards are more tolerant than datasheets, so of somebody's project these are advice.
    for (const std::string& error : board.codec_chip.errors())
        (computer ? report.faults : report.advice).push_back("codec: " + error);
    if (const std::string silence = board.codec_chip.silence(); !computer && !silence.empty())
        report.advice.push_back("codec: " + silence);
    if (const std::string silence = board.hdmi_transmitter.silence(); !silence.empty())
        report.advice.push_back("HDMI transmitter: " + silence);
    for (const std::string& fault : runner.faults()) report.faults.push_back(fault);
    report.expectations = runner.results();
    report.checks = recorder.observations().tap.checks();
    report.log_lines = recorder.log_lines();
    report.log = recorder.log();
    report.frames_shown = board.monitor.frames();
    report.frames_swapped = board.monitor.new_pictures();
    if (report.frames_shown > 0)
        report.last_frame_sha256 = sha256_hex(recorder.observations().picture().rgb);
    report.signal = board.monitor.signal();
    report.pictures = recorder.pictures();
    const BusCounts bus = processor ? processor->processor_bus().counts() : BusCounts{};
    report.bus = {bus.reads, bus.writes, bus.bursts, bus.errors};
    const auto headers = computer ? LampLog::Headers::JP : LampLog::Headers::GPIO;
    board.lamps();  // so that the log has come to now
    report.shown = recorder.lamp_log().shown(headers, board.has_arduino());
    report.lamps = recorder.lamp_log().text(headers);
    board.parts.for_each<Part>([&report](const std::string& name, Part& part) {
        if (auto told = part.final_report(name, sc_core::sc_time_stamp().value())) {
            for (const std::string& line : told->advice) report.advice.push_back(line);
            report.parts.push_back(std::move(*told));
        }
    });
    report.key_events = board.keypad.presses() + board.keypad.releases();
    report.timing_violation_count = board.monitor.violations();
    report.timing_violations = board.monitor.messages();
    report.sdram_violation_count = board.sdram_chip.violations();
    report.sdram_violations = board.sdram_chip.messages();
    if (program) {
        report.program = program->program();
        auto& lines = succeeds(report) ? report.advice : report.faults;
        for (const std::string& call : program->missing_calls())
            lines.push_back("the simulated Linux does not have a call of the program: " + call);
    }
    if (report.program && !report.program->network.empty())
        report.advice.push_back("the run had a network, so it is not reproducible: " +
                                fmt::format("{}", fmt::join(report.program->network, ", ")));
    report.audio = {recorder.observations().rate_hz, recorder.observations().samples, 0};
    if (report.simulated_s > FIRST_FRAMES_S && report.frames_shown == 0 &&
        board.monitor.is_connected())
        report.advice.push_back("the monitor found no picture: " + (report.signal.empty()
                                                                        ? board.monitor.no_signal()
                                                                        : report.signal));
    // From here on, reading moves the board.
    if (program && !program->on_linux() && waits_in_vain(report))
        for (const std::string& line : program->missed_interrupts()) report.advice.push_back(line);
    if (!computer) return;
    report.audio.underruns = underruns(*computer);
    for (const std::string& row : computer->characters()) report.characters.push_back(text_of(row));
    if (report.frames_shown < 2 || report.frames_swapped > 1 || !recorder.observations().is_black())
        return;
    if (const auto address = computer->has_own_memory() ? picture_in_ddr3(*computer) : std::nullopt)
        report.advice.push_back(
            fmt::format("the pixel buffer at 0x{:08X} is in the DDR3 memory, of which the FPGA "
                        "shows nothing: expected SDRAM (0xC0000000) or on-chip memory (0xC8000000)",
                        *address));
    else if (has_drawn(*computer))
        report.advice.push_back("the picture never changed: the firmware did not swap");
}

bool summarise(const RunReport& report, const std::filesystem::path& out) {
    std::size_t met = 0;
    for (const Expectation& e : report.expectations) {
        met += e.met;
        if (!e.met)
            message(fmt::format("{}:{}: {}: not met: {}", report.file, e.line, e.step, e.detail));
    }
    for (const Check& check : report.checks) {
        met += check.met;
        if (!check.met) message(fmt::format("{}: not met: {}", check.name, check.detail));
    }
    for (const std::string& fault : report.faults) complain(fault);
    if (waits_in_vain(report)) {
        const RunReport::Program& p = *report.program;
        if (p.exit_code)
            complain(fmt::format("the program has ended itself with exit code {}", *p.exit_code));
        else
            complain(fmt::format("the program was at PC 0x{:08X}{}{}{}{}", p.pc,
                                 p.function.empty() ? "" : " in ", p.function,
                                 p.waiting.empty() ? "" : ", waiting for ", p.waiting));
    }
    if (report.timing_violation_count)
        complain(fmt::format("{} VGA timing violations; {}", report.timing_violation_count,
                             report.timing_violations.front()));
    if (report.sdram_violation_count)
        complain(fmt::format("{} violations of the SDRAM's timing; {}",
                             report.sdram_violation_count, report.sdram_violations.front()));
    for (const std::string& line : report.advice) complain(line);
    const std::size_t decided = report.expectations.size() + report.checks.size();
    const std::string verdict =
        fmt::format("{} of {} {} met; ", met, decided,
                    report.checks.empty() ? "expectations" : "expectations and checks");
    return print_result(fmt::format(
        "{}: {}; {:.3f} s simulated in {:.2f} s, {} frames ({} new pictures), {}see {}\n{}",
        printable(name_of(report)), to_string(report.end), report.simulated_s, report.wall_s,
        report.frames_shown, report.frames_swapped, decided ? verdict : "", printable(out.string()),
        seen(report)));
}

}  // namespace sim
