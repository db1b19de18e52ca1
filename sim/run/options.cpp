// options.cpp - the options of `de1sim run`
#include "sim/run/options.h"

#include <charconv>
#include <stdexcept>

#include <CLI/CLI.hpp>

#include "sim/cpu/elf.h"
#include "sim/report/video.h"
#include "sim/run/file_kind.h"

namespace sim {

namespace {

std::uint64_t number(const std::string& text, const char* option) {
    std::uint64_t value = 0;
    const char* end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data(), end, value);
    if (error != std::errc{} || stop != end)
        throw CLI::ValidationError(option, "expected a whole number, got \"" + text + "\"");
    return value;
}

// The second run, of a part of the first: the same, but for what it writes and where.
void settle_again(RunOptions& options) {
    if (!options.replay.empty()) {
        options.scenario = options.replay;
        options.live_socket.reset();
    }
    options.out = options.again;
    options.trace = (options.again / "waves.fst").string();
    options.frames = {FrameChoice::Which::NONE, 1};
    options.html.clear();
    options.video.clear();
    options.profile.clear();
    options.gdb.reset();
    options.trace_failure.reset();
    options.duration = options.trace_to;
    options.quiet = true;
}

}  // namespace

void add_time_option(CLI::App& command, const char* name, std::optional<SimTime>& time,
                     const char* help) {
    command.add_option_function<std::string>(
        name,
        [&time, name](const std::string& text) {
            time = SimTime::parse(text);
            if (!time || time->ps == 0)
                throw CLI::ValidationError(
                    name, "expected a time such as 500ms or 10s, got \"" + text + "\"");
        },
        help);
}

std::string named(const std::string& name) {
    return name.empty() ? "expected a name, got an empty one" : "";
}

std::optional<FrameChoice> FrameChoice::parse(const std::string& text) {
    if (text == "new") return FrameChoice{Which::NEW, 1};
    if (text == "all") return FrameChoice{Which::ALL, 1};
    if (text == "last") return FrameChoice{Which::LAST, 1};
    if (text == "none") return FrameChoice{Which::NONE, 1};
    if (text.rfind("every:", 0) != 0) return std::nullopt;
    FrameChoice choice{Which::EVERY, 0};
    const char* end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data() + 6, end, choice.every);
    if (error != std::errc{} || stop != end || choice.every == 0) return std::nullopt;
    return choice;
}

void add_run_options(CLI::App& command, RunOptions& options) {
    command
        .add_option("FILE", options.scenario,
                    "scenario: YAML file with the steps to play; or a program: ELF file, to run\n"
                    "until it ends")
        ->check(named);
    command
        .add_option("--cpu", options.cpu,
                    "native: the firmware compiled for this machine;\n"
                    "arm: the board's own program, on a model of its Cortex-A9;\n"
                    "auto: arm if there is a program")
        ->check(CLI::IsMember({"auto", "native", "arm"}))
        ->capture_default_str();
    command
        .add_option("--project", options.project.place,
                    "a Quartus project (.qsf, .qpf) or a folder of Verilog as the chip's content;\n"
                    "its Platform Designer system brings the processor, if it has one; built\n"
                    "first if it has changed")
        ->check(named);
    add_project_options(command, options.project);
    command.add_flag_function(
        "--strict-vga,!--no-strict-vga",
        [&](std::int64_t times) { options.strict_vga = times > 0; },
        "what is not 640 x 480 at 60 Hz by VESA is a violation (default, but for --project);\n"
        "else the monitor locks on to what comes");
    command.add_option("--elf", options.elf, "the program, instead of the scenario's")
        ->check(named);
    command
        .add_option("--cpi", options.cpi,
                    "clocks of 800 MHz that an instruction takes, for --cpu arm: 0.1 to 100")
        ->capture_default_str();
    command.add_flag(
        "!--no-shortcuts", options.shortcuts,
        "executes every round of loops that only wait or count, too; what comes out is\n"
        "the same, later");
    command
        .add_option("--fpga-memory", options.memory,
                    "how the processor reaches the SDRAM and the on-chip memory.  mapped: at once\n"
                    "(default); bridge: every access goes through the bridge's Verilog")
        ->check(CLI::IsMember({"mapped", "bridge"}));
    command.add_option_function<std::string>(
        "--gdb",
        [&](const std::string& text) {
            const std::uint64_t port = number(text, "--gdb");
            if (port > 65535)
                throw CLI::ValidationError("--gdb", "expected a port from 0 to 65535, got " + text);
            options.gdb = static_cast<unsigned>(port);
        },
        "wait for GDB at this port of 127.0.0.1, for --cpu arm; 0 takes a free one");
    command
        .add_option("--system", options.system,
                    "what the ELF runs on: bare metal, Linux (its system calls are answered), or\n"
                    "as its ABI note says")
        ->check(CLI::IsMember({"auto", "bare", "linux"}))
        ->capture_default_str();
    command
        .add_option("--linux-root", options.linux_root,
                    "folder that a Linux program sees as /; without it there are no files\n"
                    "but /dev/mem")
        ->check(named);
    command
        .add_option("--stdin", options.input,
                    "file that is a Linux program's standard input, instead of what type-serial "
                    "types")
        ->check(named);
    command
        .add_option("--profile", options.profile,
                    "write instructions by function, for --cpu arm (callgrind format,\n"
                    "for KCachegrind and callgrind_annotate)")
        ->check(named);
    command
        .add_option("--out", options.out,
                    "folder for frames/, audio.wav, console.txt, report.json, junit.xml;\n"
                    "files of those names from an earlier run are replaced")
        ->check(named)
        ->capture_default_str();
    command.add_option_function<std::string>(
        "--frames",
        [&](const std::string& text) {
            const auto choice = FrameChoice::parse(text);
            if (!choice)
                throw CLI::ValidationError(
                    "--frames", "expected new, all, every:N, last or none, got \"" + text + "\"");
            options.frames = *choice;
        },
        "which frames become PNG: new, whose picture differs from the frame before (default),\n"
        "all, every:N, last, none");
    add_time_option(command, "--duration", options.duration,
                    "simulated time to run for at most, instead of the scenario's: 500ms, 10s");
    command.add_option_function<std::string>(
        "--seed", [&](const std::string& text) { options.seed = number(text, "--seed"); },
        "seed of the contact bounce, instead of the scenario's");
    command
        .add_option(
            "--audio-rate", options.audio_rate,
            "samples per second of the audio core and codec: 8000 as in the DE1-SoC Computer\n"
            "(default), or 48000, which is a parameter of the system on the board")
        ->check(CLI::IsMember({8'000u, 48'000u}));
    command
        .add_option("--html", options.html,
                    "write one page with all of the run: steps, pictures, sound, lamps, console")
        ->check(named);
    command.add_option("--trace", options.trace, "write waveforms (FST, for GTKWave); slow")
        ->check(named);
    add_time_option(
        command, "--trace-from", options.trace_from,
        "from when on the waveforms are written; beside FILE.fst then also FILE.bus.txt, the\n"
        "processor's bus accesses in that time, and FILE.calls.txt, its last 1,000 function\n"
        "calls (--cpu arm)");
    add_time_option(command, "--trace-to", options.trace_to, "until when");
    add_time_option(
        command, "--trace-failure", options.trace_failure,
        "where the run fails, run it again, and write waveforms, accesses and calls of this\n"
        "time before the failure into failure/ of the output folder: 20ms");
    command.add_option("--again", options.again)->group("");
    command.add_option("--replay", options.replay)->group("");
    command.add_option("--live-socket", options.live_socket)->group("");
    command
        .add_option("--video", options.video,
                    "write pictures and sound as a film: FILE.mp4 (H.264, AAC) or FILE.webm (VP9,\n"
                    "Opus)")
        ->check([](const std::string& name) {
            return is_video_name(name) ? "" : "expected FILE.mp4 or FILE.webm, got \"" + name + '"';
        });
    command.add_flag(
        "--update-goldens", options.update_goldens,
        "write golden pictures anew that differ, and those that are not there yet: the\n"
        "expectation is then met");
    command.add_flag("--quiet", options.quiet,
                     "no progress, nothing of what the program prints, and no summary unless\n"
                     "something failed");
}

void settle_run_options(const CLI::App& command, RunOptions& options) {
    if (!options.scenario.empty() && is_elf(options.scenario)) {
        if (!options.elf.empty())
            throw CLI::ValidationError("--elf",
                                       "and a program in place of the scenario exclude "
                                       "each other");
        options.elf = std::move(options.scenario);
        options.scenario.clear();
    }
    if (!options.scenario.empty()) refuse_other_kinds(options.scenario);
    if (!options.again.empty()) settle_again(options);
    const bool live = options.live_socket.has_value();
    if (options.scenario.empty() && options.elf.empty() && !live)
        throw CLI::ValidationError("FILE", "expected a scenario or a program");
    if (!options.project.place.empty()) {
        if (options.scenario.empty() && options.elf.empty() && !live)
            throw CLI::ValidationError("--project", "expected a scenario or a program with it");
        if (options.cpu == "native")
            throw CLI::ValidationError("--cpu",
                                       "native is this project's own firmware, for which "
                                       "--project has no place");
        for (const char* option : {"--fpga-memory", "--audio-rate"})
            if (command.count(option) > 0)
                throw CLI::ValidationError(option, "and --project exclude each other");
    }
    if (options.cpu == "native" && !options.elf.empty())
        throw CLI::ValidationError("--elf", "is for --cpu arm");
    if (!(options.cpi >= 0.1 && options.cpi <= 100))  // nor NaN, which CLI::Range lets through
        throw CLI::ValidationError("--cpi", "expected a number from 0.1 to 100");
    for (const char* option :
         {"--cpi", "--no-shortcuts", "--gdb", "--system", "--linux-root", "--stdin", "--profile"})
        if (command.count(option) > 0) options.for_arm.push_back(option);
    if (!options.arguments.empty()) options.for_arm.push_back("--");
    if (traces_a_part(options) && options.trace.empty())
        throw CLI::ValidationError(options.trace_from ? "--trace-from" : "--trace-to",
                                   "needs --trace FILE");
    if (options.trace_from && options.trace_to && !(*options.trace_from < *options.trace_to))
        throw CLI::ValidationError("--trace-to", "expected a time after --trace-from");
    if (options.trace_failure && (!options.trace.empty() || options.gdb || live))
        throw CLI::ValidationError("--trace-failure", std::string{"and "} +
                                                          (live          ? "live"
                                                           : options.gdb ? "--gdb"
                                                                         : "--trace") +
                                                          " exclude each other");
    if (options.gdb && !options.profile.empty())
        throw CLI::ValidationError("--profile", "and --gdb exclude each other");
}

void settle_by_scenario(RunOptions& options, const Scenario& scenario) {
    if (options.project.place.empty() && options.cpu != "native")
        options.project.place = scenario.project;
    if (!options.memory)
        options.memory = scenario.memory_bridged.value_or(false) ? "bridge" : "mapped";
    if (!options.audio_rate) options.audio_rate = scenario.audio_rate.value_or(8'000);
    if (!options.project.place.empty()) {
        if (options.elf.empty()) options.elf = scenario.program;
        if (options.cpu == "arm" && options.elf.empty())
            throw std::runtime_error{"--cpu: arm needs a program: --elf FILE"};
        options.cpu = options.elf.empty() ? "none" : "arm";
        if (options.cpu == "arm") return;
        if (!options.for_arm.empty())
            throw std::runtime_error{options.for_arm.front() + ": is for --cpu arm"};
        return;
    }
    if (options.cpu == "auto" && options.elf.empty() && !scenario.cpu.empty())
        options.cpu = scenario.cpu;
    if (options.elf.empty() && options.cpu != "native") options.elf = scenario.program;
    if (options.cpu == "auto") options.cpu = options.elf.empty() ? "native" : "arm";
    if (options.cpu == "arm" && options.elf.empty())
        throw std::runtime_error{"--cpu: arm needs a program: --elf FILE"};
    if (options.cpu == "native" && !options.for_arm.empty())
        throw std::runtime_error{options.for_arm.front() + ": is for --cpu arm"};
}

}  // namespace sim
