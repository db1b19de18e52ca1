#include "sim/run/cli.h"

#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cstring>
#include <filesystem>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "sim/fpga/fabric.h"
#include "sim/report/printable.h"
#include "sim/run/run.h"

namespace sim {

namespace {

constexpr const char* TRACING_BUILD = "de1sim-trace";

std::uint64_t number(const std::string& text, const char* option) {
    std::uint64_t value = 0;
    const char* end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data(), end, value);
    if (error != std::errc{} || stop != end)
        throw CLI::ValidationError(option, "expected a whole number, got \"" + text + "\"");
    return value;
}

// The ordinary build pays nothing for tracing: the tracing one takes over, with the same arguments.
[[noreturn]] void become_tracing_build(char** argv) {
    std::error_code error;
    const auto self = std::filesystem::read_symlink("/proc/self/exe", error);
    const auto path = self.parent_path() / TRACING_BUILD;
    if (!error) execv(path.c_str(), argv);
    fmt::print(stderr, "de1sim: {}: cannot be started for --trace: {}\n", path.string(),
               std::strerror(errno));
    std::exit(WRONG_INPUT);
}

}  // namespace

std::optional<FrameChoice> FrameChoice::parse(const std::string& text) {
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

int main(int argc, char** argv, const Firmware& firmware) {
    CLI::App app{
        "DE1-SoC, headless: your Verilog and your firmware, with picture and sound as files",
        "de1sim"};
    app.set_version_flag("--version", "de1sim " DE1SIM_VERSION);
    app.require_subcommand(1);
    app.footer(
        "What follows -- are the arguments of a Linux program.\n"
        "Exit code: 0 all expectations met; 1 an expectation missed or the firmware faulted;\n"
        "2 wrong usage or input; 130 interrupted.");

    RunOptions options;
    CLI::App& run_command = *app.add_subcommand("run", "play a scenario");
    run_command.add_option("SCENARIO", options.scenario, "YAML file with the steps to play")
        ->required();
    run_command
        .add_option("--cpu", options.cpu,
                    "native: the firmware compiled for this machine;\n"
                    "arm: the board's own program, on a model of its Cortex-A9")
        ->check(CLI::IsMember({"native", "arm"}))
        ->capture_default_str();
    run_command.add_option("--elf", options.elf, "the program for --cpu arm");
    run_command
        .add_option("--cpi", options.cpi,
                    "clocks of 800 MHz that an instruction takes, for --cpu arm: 0.1 to 100")
        ->capture_default_str();
    run_command.add_option_function<std::string>(
        "--gdb",
        [&](const std::string& text) {
            const std::uint64_t port = number(text, "--gdb");
            if (port > 65535)
                throw CLI::ValidationError("--gdb", "expected a port from 0 to 65535, got " + text);
            options.gdb = static_cast<unsigned>(port);
        },
        "wait for GDB at this port of 127.0.0.1, for --cpu arm; 0 takes a free one");
    run_command
        .add_option("--system", options.system,
                    "what the ELF runs on: bare metal, Linux (its system calls are answered), or\n"
                    "as its ABI note says")
        ->check(CLI::IsMember({"auto", "bare", "linux"}))
        ->capture_default_str();
    run_command.add_option("--linux-root", options.linux_root,
                           "folder that a Linux program sees as /; without it there are no files\n"
                           "but /dev/mem");
    run_command.add_option("--profile", options.profile,
                           "write instructions by function, for --cpu arm (callgrind format,\n"
                           "for KCachegrind and callgrind_annotate)");
    run_command
        .add_option("--out", options.out,
                    "folder for frames/, audio.wav, console.txt, report.json, junit.xml;\n"
                    "files of those names from an earlier run are replaced")
        ->capture_default_str();
    run_command.add_option_function<std::string>(
        "--frames",
        [&](const std::string& text) {
            const auto choice = FrameChoice::parse(text);
            if (!choice)
                throw CLI::ValidationError(
                    "--frames", "expected all, every:N, last or none, got \"" + text + "\"");
            options.frames = *choice;
        },
        "which frames become PNG: all (default), every:N, last, none");
    run_command.add_option_function<std::string>(
        "--duration",
        [&](const std::string& text) {
            options.duration = SimTime::parse(text);
            if (!options.duration || options.duration->ps == 0)
                throw CLI::ValidationError(
                    "--duration", "expected a time such as 500ms or 10s, got \"" + text + "\"");
        },
        "simulated time to run for, instead of the scenario's: 500ms, 10s");
    run_command.add_option_function<std::string>(
        "--seed", [&](const std::string& text) { options.seed = number(text, "--seed"); },
        "seed of the contact bounce, instead of the scenario's");
    run_command.add_option("--trace", options.trace, "write waveforms (FST, for GTKWave); slow");
    run_command.add_flag("--quiet", options.quiet,
                         "no progress, no summary unless something failed");

    try {
        const auto words = std::find_if(
            argv, argv + argc, [](const char* word) { return std::strcmp(word, "--") == 0; });
        const bool arguments = words != argv + argc;
        if (arguments) options.arguments.assign(words + 1, argv + argc);
        app.parse(static_cast<int>(words - argv), argv);
        if (options.cpu == "arm" && options.elf.empty())
            throw CLI::ValidationError("--cpu", "arm needs a program: --elf FILE");
        if (!(options.cpi >= 0.1 && options.cpi <= 100))  // nor NaN, which CLI::Range lets through
            throw CLI::ValidationError("--cpi", "expected a number from 0.1 to 100");
        for (const char* option :
             {"--elf", "--cpi", "--gdb", "--system", "--linux-root", "--profile"})
            if (options.cpu != "arm" && run_command.count(option) > 0)
                throw CLI::ValidationError(option, "is for --cpu arm");
        if (options.gdb && !options.profile.empty())
            throw CLI::ValidationError("--profile", "and --gdb exclude each other");
        if (arguments && options.cpu != "arm") throw CLI::ValidationError("--", "is for --cpu arm");
    } catch (const CLI::ParseError& e) {
        if (e.get_exit_code() == 0) return app.exit(e), PASSED;  // --help, --version
        fmt::print(stderr, "de1sim: {} (see de1sim --help)\n",
                   argc > 1 && app.get_subcommands().empty()
                       ? fmt::format("expected run, got \"{}\"", printable(argv[1]))
                       : std::string{e.what()});
        return WRONG_INPUT;
    }
    if (!options.trace.empty() && !Fabric::can_trace()) become_tracing_build(argv);
    return run(options, firmware);
}

}  // namespace sim
