#include "sim/program.h"

#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <iterator>
#include <new>
#include <sstream>
#include <tuple>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <systemc>

#include "selftest/self_test.h"
#include "sim/fpga/fabric.h"
#include "sim/link/link.h"
#include "sim/live/command.h"
#include "sim/live/live_client.h"
#include "sim/process/shell_word.h"
#include "sim/run/check_board.h"
#include "sim/run/run.h"
#include "sim/run/version.h"
#include "sim/suite/command.h"
#include "sim/text/messages.h"

namespace sim {

namespace {

// The ordinary build pays nothing for tracing: the tracing one of the same program, which lies
// beside it, takes over with the same arguments.
ExitCode become_tracing_build(char** argv) {
    std::error_code error;
    const auto self = std::filesystem::read_symlink("/proc/self/exe", error);
    if (error) {
        complain("--trace: cannot find the tracing build: /proc/self/exe: " + error.message());
        return WRONG_INPUT;
    }
    auto tracing = self;
    tracing += "-trace";
    execv(tracing.c_str(), argv);
    complain(fmt::format("--trace: {} has no tracing build: {}: {}", self.filename().string(),
                         tracing.string(), std::strerror(errno)));
    return WRONG_INPUT;
}

// `de1sim prog.elf` is `de1sim run prog.elf`: a first word that is a file stands for itself, also
// one that is not there.
bool names_a_file(const std::string& word) {
    std::error_code error;
    return !word.empty() && word[0] != '-' &&
           (word.find_first_of("./") != std::string::npos || std::filesystem::exists(word, error));
}

bool names_a_command(CLI::App& app, const std::string& word) {
    const auto commands = app.get_subcommands([](const CLI::App*) { return true; });
    return std::any_of(commands.begin(), commands.end(),
                       [&](const CLI::App* command) { return command->get_name() == word; });
}

// A run that is played by its scenario alone.
std::unique_ptr<RunClient> nobody(int, Recorder&) { return nullptr; }

int command_line(int argc, char** argv, const Firmware& firmware) {
    CLI::App app{
        "DE1-SoC, headless: your Verilog and your firmware, with picture and sound as files",
        "de1sim"};
    app.set_version_flag("--version", VERSION);
    app.require_subcommand(1);
    app.footer(
        "`de1sim FILE ...` is `de1sim run FILE ...`.\n"
        "What follows -- are the arguments of a Linux program.\n"
        "Exit code: 0 all expectations met; 1 an expectation missed or the firmware faulted;\n"
        "2 wrong usage or input, or an output that cannot be written, or an internal error;\n"
        "130 interrupted.");

    RunOptions options;
    RunDescription check;
    CLI::App& run_command = *app.add_subcommand("run", "play a scenario, or run a program");
    add_run_options(run_command, options);
    live::LiveOptions live_options;
    CLI::App& live_command =
        *app.add_subcommand("live", "the board in a browser, to look at and to play with");
    live::add_live_options(live_command, live_options);
    ProjectOptions project;
    CLI::App& build_command =
        *app.add_subcommand("build", "build a Quartus project for run --project");
    CLI::App& examine_command = *app.add_subcommand(
        "check", "print what a Quartus project consists of, and what is wrong with it");
    for (CLI::App* command : {&build_command, &examine_command}) {
        command->add_option("PROJECT", project.place, ".qsf, .qpf or folder of Verilog")
            ->check(named)
            ->required();
        add_project_options(*command, project);
    }
    CheckPrints prints = CheckPrints::ALL;
    auto* const systems = examine_command.add_option_group("of Platform Designer's systems");
    systems->require_option(0, 1);
    for (const auto& [name, what, text] :
         {std::tuple{"--map", CheckPrints::MAP, "print who has which addresses, alone"},
          std::tuple{"--header", CheckPrints::HEADER, "print hps_0.h, the macros for C, alone"},
          std::tuple{"--device-tree", CheckPrints::DEVICE_TREE,
                     "print the nodes for Linux' device tree, alone"}})
        systems->add_flag_callback(
            name, [&prints, what = what] { prints = what; }, text);
    LinkOptions link_options;
    CLI::App& link_command = *app.add_subcommand(
        "link", "make one ARM program of Linux kernel modules and the program that uses them");
    add_link_options(link_command, link_options);
    CLI::App& check_command = *app.add_subcommand(
        "check-board", "check registers, memory, timing, keys and lamps of the simulated board");
    add_check_board_options(check_command, check);
    std::filesystem::path reports[2];
    CLI::App& compare_command = *app.add_subcommand(
        "compare", "compare the checks in two report.json: of a board and of a simulation");
    suite::TestOptions test_options;
    CLI::App& test_command = *app.add_subcommand("test", "run many scenarios, in parallel");
    suite::add_test_options(test_command, test_options);
    std::vector<std::filesystem::path> parts;
    std::filesystem::path merged = "test-results";
    CLI::App& merge_command =
        *app.add_subcommand("merge", "join the results of the shards of de1sim test");
    merge_command.add_option("FOLDER", parts, "results of a shard")->required();
    merge_command.add_option("--out", merged, "folder for what is joined")->capture_default_str();
    compare_command.add_option("A", reports[0], "report.json")->check(named)->required();
    compare_command.add_option("B", reports[1], "another")->check(named)->required();
    compare_command.footer(
        "Exit code: 0 they say the same; 1 they differ; 2 wrong usage or input.");

    RunDescription described;
    try {
        const auto arguments = std::find_if(
            argv, argv + argc, [](const char* word) { return std::strcmp(word, "--") == 0; });
        std::vector<std::string>& program_arguments = options.description.program.arguments;
        if (arguments != argv + argc) program_arguments.assign(arguments + 1, argv + argc);
        live_options.run.description.program.arguments = program_arguments;
        std::vector<std::string> ours(std::reverse_iterator{arguments},
                                      std::reverse_iterator{argv + 1});  // as CLI11 wants them
        if (!ours.empty() && !names_a_command(app, ours.back()) && names_a_file(ours.back()))
            ours.push_back("run");
        app.parse(std::move(ours));
        if (run_command.parsed())
            described = described_by(run_command, options, true);
        else if (live_command.parsed())
            described = live::described_by(live_command, live_options);
        else if (link_command.parsed())
            link_options.arguments = program_arguments;
        else if (!program_arguments.empty())
            throw CLI::ValidationError("--", "is for de1sim run, live and link");
    } catch (const CLI::ParseError& e) {
        if (e.get_exit_code() == 0) {  // --help, --version
            std::ostringstream text;
            app.exit(e, text, text);
            return print_result(text.str()) ? PASSED : WRONG_INPUT;
        }
        complain(fmt::format("{} (see de1sim --help)",
                             argc > 1 && app.get_subcommands().empty()
                                 ? fmt::format("expected run, test, live, build, check, "
                                               "link, check-board, compare or merge, got \"{}\"",
                                               argv[1])
                                 : std::string{e.what()}));
        return WRONG_INPUT;
    }
    if (live_command.parsed()) return live::live(live_options, described);
    if (build_command.parsed()) return build_project(project);
    if (link_command.parsed()) return link_program(link_options);
    if (examine_command.parsed()) return check_project(project, prints);
    if (test_command.parsed()) return suite::test(test_options);
    if (merge_command.parsed()) return suite::merge(parts, merged);
    if (compare_command.parsed()) return compare_reports(reports[0], reports[1]);
    if (check_command.parsed())
        return run(
            check, [](hal::Mmio& io, hal::Cpu& cpu) { (void)selftest::run(io, cpu); }, nobody);
    if (!described.outputs.trace.file.empty() && described.chip.project.place.empty() &&
        !Fabric::can_trace())
        return become_tracing_build(argv);
    if (options.description_file.empty())
        for (int i = 0; i < argc; ++i)
            described.command += (i ? " " : "") + shell_word(i ? argv[i] : "de1sim");
    return run(described, firmware, [](int socket, Recorder& recorder) {
        return std::make_unique<live::LiveClient>(socket, recorder);
    });
}

// sc_main() gets it no other way.
const Firmware* the_firmware = nullptr;

}  // namespace

int program(int argc, char** argv, const Firmware& firmware) {
    the_firmware = &firmware;
    setenv("SYSTEMC_DISABLE_COPYRIGHT_MESSAGE", "1", 1);  // libsystemc's banner
    return sc_core::sc_elab_and_sim(argc, argv);
}

}  // namespace sim

int sc_main(int argc, char** argv) {
    sim::prepare_standard_streams();
    std::signal(SIGXFSZ, SIG_IGN);  // a file too large is an error like a full disk
    try {
        return sim::command_line(argc, argv, *sim::the_firmware);
    } catch (const std::bad_alloc&) {
        sim::complain("out of memory while reading the command line");
    } catch (const std::exception& e) {
        sim::complain(e.what());
    }
    return sim::WRONG_INPUT;
}
