// options.h - what `de1sim run` was asked to do.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "sim/run/project_commands.h"
#include "sim/scenario/scenario.h"
#include "sim/scenario/sim_time.h"

namespace CLI {
class App;
}

namespace sim {

struct FrameChoice {
    enum class Which { NEW, ALL, EVERY, LAST, NONE };
    Which which = Which::NEW;  // those whose picture differs from the frame before
    std::uint64_t every = 1;   // for EVERY: frames whose number is a multiple of it

    // "new", "all", "every:N" with N > 0, "last", "none"
    static std::optional<FrameChoice> parse(const std::string& text);
    bool wants(std::uint64_t number, bool is_new) const {
        return which == Which::ALL || (which == Which::NEW && is_new) ||
               (which == Which::EVERY && number % every == 0);
    }
};

struct RunOptions {
    std::filesystem::path scenario;            // or empty: the program alone
    std::optional<std::string> scenario_text;  // instead of the file's
    std::filesystem::path out = "out";
    std::string cpu = "auto";            // "native", "arm"; "auto": arm, if there is a program
    ProjectOptions project;              // in the chip, without a processor; or none
    std::optional<bool> strict_vga;      // else: yes, but for a project
    std::filesystem::path elf;           // for the processor "arm", or empty
    std::vector<std::string> for_arm;    // options that were given and are for "arm" alone
    double cpi = 1;                      // clocks per instruction of that processor
    bool shortcuts = true;               // steady loops are not executed round by round
    std::optional<std::string> memory;   // how it reaches the FPGA's memories: "mapped", "bridge"
    std::string system = "auto";         // what the ELF expects: "bare", "linux", "auto"
    std::filesystem::path linux_root;    // the Linux program's /, or empty
    std::vector<std::string> arguments;  // the Linux program's, behind its name
    std::filesystem::path input;         // the Linux program's standard input, or empty
    std::filesystem::path profile;       // callgrind file, or empty
    std::optional<unsigned> gdb;         // port for a debugger of that processor
    FrameChoice frames;
    std::optional<SimTime> duration;              // instead of the scenario's
    std::optional<std::uint64_t> seed;            // instead of the scenario's
    std::string trace;                            // FST file, or empty
    std::optional<SimTime> trace_from, trace_to;  // the part of the run that is traced; else all
    std::optional<SimTime> trace_failure;      // the time before a failure that a second run traces
    std::filesystem::path again;               // that second run's folder, or empty
    std::filesystem::path replay;              // scenario that it plays instead, or empty
    std::vector<std::string> arguments_typed;  // all that was given behind `run`
    std::filesystem::path html;                // a page with all of the run, or empty
    std::string command, version;              // for that page
    std::filesystem::path video;               // .mp4 or .webm, or empty
    std::optional<unsigned> audio_rate;        // samples per second
    bool update_goldens = false;               // where they differ
    bool quiet = false;
    std::optional<int> live_socket;  // to `de1sim live`, whose simulation this is
};

inline bool traces_a_part(const RunOptions& o) { return o.trace_from || o.trace_to; }

// A check for CLI11: what is wrong with the name of a file or folder, or nothing.
std::string named(const std::string& name);

// An option that is a time after 0.  CLI::ValidationError.
void add_time_option(CLI::App& command, const char* name, std::optional<SimTime>& time,
                     const char* help);

// Describes the options to CLI11, which fills `options` when it parses.
void add_run_options(CLI::App& command, RunOptions& options);
// What they mean together: a program in the scenario's place, options that exclude each other.
// CLI::ValidationError.
void settle_run_options(const CLI::App& command, RunOptions& options);

// Adds what the scenario says and the command line does not: what is in the chip, the processor.
// std::runtime_error for options that this has no use for.
void settle_by_scenario(RunOptions& options, const Scenario& scenario);

}  // namespace sim
