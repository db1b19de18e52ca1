// options.cpp - the options of `de1sim run`
#include "sim/run/options.h"

#include <charconv>
#include <stdexcept>

#include <CLI/CLI.hpp>

#include "sim/cpu/elf.h"
#include "sim/files/whole_file.h"
#include "sim/run/file_kind.h"
#include "sim/video/video.h"

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

void add_run_options(CLI::App& command, RunOptions& options) {
    RunDescription& run = options.description;
    ChipDescription& chip = run.chip;
    ProgramDescription& program = run.program;
    RunOutputs& outputs = run.outputs;
    command
        .add_option("FILE", options.file,
                    "scenario: YAML file with the steps to play; or a program: ELF file, to run\n"
                    "until it ends")
        ->check(named);
    command
        .add_option("--cpu", program.cpu,
                    "native: the firmware compiled for this machine;\n"
                    "arm: the board's own program, on a model of its Cortex-A9;\n"
                    "auto: arm if there is a program")
        ->check(CLI::IsMember({"auto", "native", "arm"}))
        ->capture_default_str();
    command
        .add_option("--project", chip.project.place,
                    "a Quartus project (.qsf, .qpf) or a folder of Verilog as the chip's content;\n"
                    "its Platform Designer system brings the processor, if it has one; built\n"
                    "first if it has changed")
        ->check(named);
    add_project_options(command, chip.project);
    command.add_flag_function(
        "--strict-vga,!--no-strict-vga", [&](std::int64_t times) { chip.strict_vga = times > 0; },
        "what is not 640 x 480 at 60 Hz by VESA is a violation (default, but for --project);\n"
        "else the monitor locks on to what comes");
    command.add_option("--elf", program.elf, "the program, instead of the scenario's")
        ->check(named);
    command
        .add_option("--cpi", program.cpi,
                    "clocks of 800 MHz that an instruction takes, for --cpu arm: 0.1 to 100")
        ->capture_default_str();
    command.add_flag(
        "!--no-shortcuts", program.shortcuts,
        "executes every round of loops that only wait or count, too; what comes out is\n"
        "the same, later");
    command
        .add_option_function<std::string>(
            "--fpga-memory", [&](const std::string& how) { chip.bridged_memory = how == "bridge"; },
            "how the processor reaches the SDRAM and the on-chip memory.  mapped: at once\n"
            "(default); bridge: every access goes through the bridge's Verilog")
        ->check(CLI::IsMember({"mapped", "bridge"}));
    command
        .add_option("--ddr3-rate", chip.ddr3_mb_per_s,
                    "MB/s of the processor's DDR3 for masters in the FPGA, 1 to 100000, for\n"
                    "--project; 3200 by default")
        ->check(CLI::Range(1u, 100'000u));
    command.add_option_function<std::string>(
        "--gdb",
        [&](const std::string& text) {
            const std::uint64_t port = number(text, "--gdb");
            if (port > 65535)
                throw CLI::ValidationError("--gdb", "expected a port from 0 to 65535, got " + text);
            outputs.gdb = static_cast<unsigned>(port);
        },
        "wait for GDB at this port of 127.0.0.1, for a program; 0 takes a free one");
    command
        .add_option("--system", program.system,
                    "what the ELF runs on: bare metal, Linux (its system calls are answered), or\n"
                    "as its ABI note says")
        ->check(CLI::IsMember({"auto", "bare", "linux"}))
        ->capture_default_str();
    command
        .add_option("--linux-root", program.linux_root,
                    "folder that a Linux program sees as /; without it there are no files\n"
                    "but /dev/mem and the cross compiler's libraries")
        ->check(named);
    command
        .add_option("--module", program.modules,
                    "kernel module that de1sim link has made, loaded before the Linux program,\n"
                    "with its parameters: \"dial.ko period=5\"; one for each option")
        ->check(named);
    command
        .add_option("--stdin", program.input,
                    "file that is a Linux program's standard input, instead of what type-serial "
                    "types")
        ->check(named);
    command
        .add_option("--network", program.network,
                    "HOST:PORT[,HOST:PORT...] that a Linux program reaches over this machine's\n"
                    "network, by TCP and UDP; such a run is not reproducible")
        ->delimiter(',')
        ->allow_extra_args(false)
        ->check(named);
    command
        .add_option("--profile", outputs.profile,
                    "write instructions by function, for a program (callgrind format,\n"
                    "for KCachegrind and callgrind_annotate)")
        ->check(named);
    command
        .add_option("--out", outputs.out,
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
            outputs.frames = *choice;
        },
        "which frames become PNG: new, whose picture differs from the frame before (default),\n"
        "all, every:N, last, none");
    add_time_option(command, "--duration", run.duration,
                    "simulated time to run for at most, instead of the scenario's: 500ms, 10s");
    command.add_option_function<std::string>(
        "--seed", [&](const std::string& text) { run.seed = number(text, "--seed"); },
        "seed of the contact bounce, instead of the scenario's");
    command
        .add_option(
            "--audio-rate", chip.audio_rate,
            "samples per second of the audio core and codec: 8000 as in the DE1-SoC Computer\n"
            "(default), or 48000, which is a parameter of the system on the board")
        ->check(CLI::IsMember({8'000u, 48'000u}));
    command
        .add_option("--html", outputs.html,
                    "write one page with all of the run: steps, pictures, sound, lamps, console")
        ->check(named);
    command.add_option("--trace", outputs.trace.file, "write waveforms (FST, for GTKWave); slow")
        ->check(named);
    add_time_option(
        command, "--trace-from", outputs.trace.from,
        "from when on the waveforms are written; beside FILE.fst then also FILE.bus.txt, the\n"
        "processor's bus accesses in that time, and FILE.calls.txt, its last 1,000 function\n"
        "calls (--cpu arm)");
    add_time_option(command, "--trace-to", outputs.trace.to, "until when");
    add_time_option(
        command, "--trace-failure", outputs.trace_failure,
        "where the run fails, run it again, and write waveforms, accesses and calls of this\n"
        "time before the failure into failure/ of the output folder: 20ms");
    command
        .add_option("--video", outputs.video,
                    "write pictures and sound as a film: FILE.mp4 (H.264, AAC) or FILE.webm (VP9,\n"
                    "Opus)")
        ->check([](const std::string& name) {
            return is_video_name(name) ? "" : "expected FILE.mp4 or FILE.webm, got \"" + name + '"';
        });
    command.add_flag(
        "--update-goldens", outputs.update_goldens,
        "replace golden pictures that differ, and write those that are not there yet: the\n"
        "expectation is then met");
    command.add_flag("--quiet", outputs.quiet,
                     "no progress, nothing of what the program prints, and no summary unless\n"
                     "something failed");
    command
        .add_option("--description", options.description_file,
                    "the whole run as de1sim live and test describe it to their runs (JSON), in\n"
                    "place of all other options")
        ->check(named);
}

namespace {

void refuse_other_options(const CLI::App& command) {
    for (const CLI::Option* option : command.get_options())
        if (option->count() > 0 && !option->check_lname("description"))
            throw CLI::ValidationError(option->get_name(), "and --description exclude each other");
}

RunDescription described_in(const std::filesystem::path& file) {
    constexpr std::size_t MOST_BYTES = 64u << 20;
    return description_from(read_whole_file(file, MOST_BYTES), file.string());
}

// Whatever has made it.
void check(const RunDescription& run, bool needs_file) {
    if (needs_file && run.scenario.empty() && run.program.elf.empty()) {
        if (run.chip.project.place.empty())
            throw CLI::ValidationError("FILE", "expected a scenario or a program");
        throw CLI::ValidationError("--project", "expected a scenario or a program with it");
    }
    const ProgramDescription& program = run.program;
    const RunOutputs& outputs = run.outputs;
    const TraceDescription& trace = outputs.trace;
    if (!run.chip.project.place.empty() && program.cpu == "native")
        throw CLI::ValidationError("--cpu",
                                   "native is this project's own firmware, for which "
                                   "--project has no place");
    if (program.cpu == "native" && !program.elf.empty())
        throw CLI::ValidationError("--elf", "is for --cpu arm");
    if (!(program.cpi >= 0.1 && program.cpi <= 100))  // nor NaN, which CLI::Range lets through
        throw CLI::ValidationError("--cpi", "expected a number from 0.1 to 100");
    if (trace.is_of_a_part() && trace.file.empty())
        throw CLI::ValidationError(trace.from ? "--trace-from" : "--trace-to",
                                   "needs --trace FILE");
    if (trace.from && trace.to && !(*trace.from < *trace.to))
        throw CLI::ValidationError("--trace-to", "expected a time after --trace-from");
    const bool live = outputs.live_socket.has_value();
    if (outputs.trace_failure && (!trace.file.empty() || outputs.gdb || live))
        throw CLI::ValidationError("--trace-failure", std::string{"and "} +
                                                          (live          ? "live"
                                                           : outputs.gdb ? "--gdb"
                                                                         : "--trace") +
                                                          " exclude each other");
    if (outputs.trace_failure && !program.network.empty())
        throw CLI::ValidationError("--trace-failure",
                                   "and --network exclude each other: a second run may differ");
    if (outputs.gdb && !outputs.profile.empty())
        throw CLI::ValidationError("--profile", "and --gdb exclude each other");
}

}  // namespace

RunDescription described_by(const CLI::App& command, const RunOptions& options, bool needs_file) {
    if (!options.description_file.empty()) {
        refuse_other_options(command);
        RunDescription run = described_in(options.description_file);
        check(run, !run.outputs.live_socket);
        return run;
    }
    RunDescription run = options.description;
    run.scenario = options.file;
    if (!run.scenario.empty() && is_elf(run.scenario)) {
        if (!run.program.elf.empty())
            throw CLI::ValidationError("--elf",
                                       "and a program in place of the scenario exclude "
                                       "each other");
        run.program.elf = std::move(run.scenario);
        run.scenario.clear();
    }
    if (!run.scenario.empty()) refuse_other_kinds(run.scenario);
    for (const char* option : {"--cpi", "--no-shortcuts", "--gdb", "--system", "--linux-root",
                               "--module", "--stdin", "--network", "--profile", "--ddr3-rate"})
        if (command.count(option) > 0) run.program.arm_options.push_back(option);
    if (!run.program.arguments.empty()) run.program.arm_options.push_back("--");
    check(run, needs_file);
    return run;
}

}  // namespace sim
