#include "sim/run/project_commands.h"

#include <algorithm>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "sim/project/init_checks.h"
#include "sim/project/tools.h"
#include "sim/run/run.h"
#include "sim/text/messages.h"

namespace sim {

using project::Binding;

namespace {

// "LEDR[9:0] -> LEDR", or bit by bit where they lie elsewhere.
std::string bound(const Binding::BoundPort& port) {
    const std::string range =
        port.port.vector ? fmt::format("[{}:{}]", port.port.left, port.port.right) : "";
    std::string wires;
    for (const auto& bit : port.bits)
        wires += (wires.empty() ? "" : " ") + (bit.signal.empty() ? std::string{"-"} : bit.signal);
    if (port.bits.size() > 1 && !port.bits.front().signal.empty() &&
        !port.bits.back().signal.empty())
        wires = port.bits.front().signal + " ... " + port.bits.back().signal;
    return fmt::format("  {:6} {:24} {}\n",
                       port.port.direction == Direction::INPUT    ? "input"
                       : port.port.direction == Direction::OUTPUT ? "output"
                                                                  : "inout",
                       port.port.name + range, wires);
}

std::string lines(const char* title, const std::vector<std::string>& all) {
    std::string text;
    for (const std::string& line : all) text += "  " + line + "\n";
    return all.empty() ? "" : fmt::format("{}:\n{}", title, text);
}

// What each master reaches; the processor's bridges by its own addresses.
std::string addresses(const project::qsys::Generated& system) {
    std::string text, master;
    for (const project::qsys::Place& place : system.map) {
        if (place.master != master)
            text += fmt::format("addresses of {}:\n", master = place.master);
        const std::uint64_t base = place.base + place.window;
        text +=
            fmt::format("  0x{:08X} - 0x{:08X}  {}{}\n", base, base + place.span - 1, place.slave,
                        place.reads && place.writes ? ""
                        : place.reads               ? "  (reads alone)"
                                                    : "  (writes alone)");
    }
    return text;
}

// "font.mif (rom.v:12): data/font.mif"
std::string found(const project::InitFile& wanted, const project::Project& project) {
    const auto file = project::find_init_file(wanted.name, project::init_folders(project));
    return fmt::format("{} ({}): {}", wanted.name, wanted.place,
                       file ? file->lexically_relative(project.folder).string()
                            : "not found, the memory will begin with zeros");
}

}  // namespace

project::Request ProjectOptions::request() const {
    project::Request request;
    request.place = place;
    request.top = top;
    request.board = board;
    request.macros = macros;
    request.build_limit_s = build_limit_s;
    request.is_model = [](const std::string& module) {
        return project::model_of(module).has_value();
    };
    return request;
}

void add_project_options(CLI::App& command, ProjectOptions& options) {
    command.add_option("--top", options.top, "the project's top module, instead of its own choice");
    command.add_option(
        "--board", options.board,
        "the board that the project is for, instead of what DEVICE and pins tell; or,\n"
        "without a project, whose computer the program is for: de1-soc, de10-standard, de10-lite");
    command.add_option("-D,--define", options.macros, "a Verilog macro: NAME or NAME=VALUE")
        ->take_all();
    command
        .add_option("--build-limit", options.build_limit_s,
                    "seconds that building the project may take")
        ->check(CLI::Range(1u, 1'000'000u))
        ->capture_default_str();
}

namespace {

// The notes may hold the cause of what is refused then.
const project::Design& examine(project::Builder& builder) {
    try {
        return builder.examine();
    } catch (const project::ProjectError& error) {
        for (const std::string& note : error.notes) message(note);
        throw;
    }
}

}  // namespace

project::Built build_with_progress(
    const ProjectOptions& options, bool trace, bool quiet,
    const std::function<void(const project::BoardDescription&)>& on_board) {
    project::Builder builder{options.request(), trace};
    const project::Design& design = examine(builder);
    if (!quiet) {
        for (const std::string& note : design.project.notes) message(note);
        for (const std::string& note : design.binding.notes) message(note);
        if (const std::size_t count = design.warnings.size())
            message(fmt::format("{} warning{} as Quartus would give; `de1sim check` lists {}",
                                count, count > 1 ? "s" : "", count > 1 ? "them" : "it"));
    }
    if (on_board) on_board(design.project.board);
    return builder.build([quiet](const std::string& line) {
        if (!quiet) message(line);
    });
}

int build_project(const ProjectOptions& options) {
    const project::Built built = build_with_progress(options, false, false);
    return print_result(fmt::format("{}: {}\n", built.library.string(),
                                    built.was_up_to_date ? "is up to date" : "built"))
               ? PASSED
               : WRONG_INPUT;
}

namespace {

// Of the Platform Designer systems, without Verilator.
int print_systems(const ProjectOptions& options, CheckPrints prints) {
    const project::Project project = project::read_project(options.request());
    if (project.systems.empty())
        throw project::ProjectError{
            fmt::format("{} has no Platform Designer system", options.place.string())};
    std::string text;
    for (const auto& system : project.systems)
        if (prints != CheckPrints::MAP && system.has_processor && system.devices.empty() &&
            system.text.empty())
            throw project::ProjectError{
                fmt::format("{}: of its Platform Designer system that is taken which was made of "
                            "the .qsys, which does not tell the kinds of its components",
                            options.place.string())};
    for (const auto& system : project.systems)
        text += prints == CheckPrints::MAP ? addresses(system)
                : prints == CheckPrints::HEADER
                    ? project::qsys::header_text(system.name, system.devices)
                    : project::qsys::device_tree_text(system.devices);
    return print_result(text) ? PASSED : WRONG_INPUT;
}

}  // namespace

int check_project(const ProjectOptions& options, CheckPrints prints) {
    if (prints != CheckPrints::ALL) return print_systems(options, prints);
    project::Builder builder{options.request(), false};
    const project::Design& design = examine(builder);
    std::string text = fmt::format("board: {}\ntop module: {}\nfiles:\n", design.project.board.name,
                                   design.project.top);
    for (const auto& file : design.project.sources)
        text +=
            fmt::format("  {}{}\n", file.path.lexically_relative(design.project.folder).string(),
                        file.listed ? "" : "  (found, not listed)");
    text += "ports:\n";
    for (const auto& port : design.binding.ports) text += bound(port);
    for (const auto& system : design.project.systems) text += addresses(system);
    text += "clocks:\n";
    for (const project::BoardSignal& signal : design.project.board.signals)
        if (signal.wires.front() == "CLOCK_50") text += "  " + signal.name + ": 50 MHz\n";
    for (const auto& clock : design.elaborated.pll_clocks)
        text += fmt::format("  {}: {:.6f} MHz, phase {:.3f} ns{}\n", fmt::join(clock.names, ", "),
                            1e9 / static_cast<double>(clock.period_fs),
                            static_cast<double>(clock.phase_fs) * 1e-6,
                            clock.is_settable ? ", until it is reconfigured" : "");
    std::vector<std::string> init_files;
    for (const auto& file : design.init_files) init_files.push_back(found(file, design.project));
    text += lines("initial words of memories", init_files);
    text += lines("notes", design.project.notes);
    text += lines("pins", design.binding.notes);
    std::vector<std::string> warnings;
    for (const project::Message& m : design.warnings) {
        // What is said of several lines of a file is said once.
        const std::string words = fmt::format(": {}: {}", m.number, m.text), place = m.file + ":";
        const auto same = std::find_if(warnings.begin(), warnings.end(), [&](const auto& line) {
            return line.compare(0, place.size(), place) == 0 && line.size() > words.size() &&
                   line.compare(line.size() - words.size(), words.size(), words) == 0;
        });
        if (same == warnings.end())
            warnings.push_back(line_of(m));
        else
            same->insert(same->size() - words.size(), fmt::format(",{}", m.line));
    }
    text += lines("warnings, with Quartus' numbers", warnings);
    text += lines("changed for the simulation", design.changes);
    return print_result(text) ? PASSED : WRONG_INPUT;
}

}  // namespace sim
