// description.h - a run as data: what is in the chip, what plays, what is written and who watches.
//
// The command line is one way to make it (options.h); `de1sim live`, `de1sim test` and a second run
// for waveforms are others, which hand it to another process as JSON.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "sim/run/project_commands.h"
#include "sim/scenario/sim_time.h"

namespace sim {

struct FrameChoice {
    enum class Which { NEW, ALL, EVERY, LAST, NONE };
    Which which = Which::NEW;  // those whose picture differs from the frame before
    std::uint64_t every = 1;   // for EVERY: frames whose number is a multiple of it

    // "new", "all", "every:N" with N > 0, "last", "none"
    static std::optional<FrameChoice> parse(const std::string& text);
    std::string text() const;
    bool wants(std::uint64_t number, bool is_new) const {
        return which == Which::ALL || (which == Which::NEW && is_new) ||
               (which == Which::EVERY && number % every == 0);
    }
};

// A value that is not there is the scenario's, or else the default.
struct ChipDescription {
    ProjectOptions project;                 // none: our own computer
    std::optional<bool> bridged_memory;     // the processor's way to our computer's memories
    std::optional<unsigned> audio_rate;     // of our computer, in samples per second
    std::optional<bool> strict_vga;         // else: yes, but for a project
    std::optional<unsigned> ddr3_mb_per_s;  // for a project's masters
};

struct ProgramDescription {
    std::string cpu = "auto";              // "native", "arm"; "auto": arm, if there is a program
    std::filesystem::path elf;             // or empty: the scenario's
    double cpi = 1;                        // clocks per instruction, 0.1 to 100
    bool shortcuts = true;                 // steady loops are not executed round by round
    std::string system = "auto";           // what the ELF expects: "bare", "linux", "auto"
    std::filesystem::path linux_root;      // the Linux program's /, or empty
    std::vector<std::string> arguments;    // the Linux program's, after its name
    std::vector<std::string> modules;      // kernel modules, "dial.ko period=5"
    std::filesystem::path input;           // the Linux program's standard input, or empty
    std::vector<std::string> network;      // outside, that it reaches: "host:port"
    std::vector<std::string> arm_options;  // of the command line, which are for "arm" alone
};

struct TraceDescription {
    std::string file;                 // FST, or empty
    std::optional<SimTime> from, to;  // the part of the run that is traced; else all

    bool is_of_a_part() const { return from || to; }
};

struct RunOutputs {
    std::filesystem::path out = "out";
    FrameChoice frames;
    std::filesystem::path html;     // a page with all of the run, or empty
    std::filesystem::path video;    // .mp4 or .webm, or empty
    std::filesystem::path profile;  // callgrind file, or empty
    TraceDescription trace;
    std::optional<SimTime> trace_failure;  // the time before a failure that a second run traces
    std::optional<unsigned> gdb;           // port for a debugger
    std::optional<int> live_socket;        // to `de1sim live`, whose simulation this is
    bool update_goldens = false;           // where they differ
    bool quiet = false;
};

struct RunDescription {
    std::filesystem::path scenario;            // or empty: the program alone
    std::optional<std::string> scenario_text;  // in place of the file's
    ChipDescription chip;
    ProgramDescription program;
    RunOutputs outputs;
    std::optional<SimTime> duration;    // in place of the scenario's
    std::optional<std::uint64_t> seed;  // in place of the scenario's
    std::string command;                // that a person typed, for the page; or empty
};

// One line of JSON, and back.  std::runtime_error: `text` is no such description; `name` is its
// file's, for the message.
std::string to_json(const RunDescription& description);
RunDescription description_from(const std::string& text, const std::string& name);

// A description in memory, at a path that processes have which this one starts while it is there.
class DescriptionFile {
public:
    // std::runtime_error
    explicit DescriptionFile(const RunDescription& description);
    ~DescriptionFile();
    DescriptionFile(const DescriptionFile&) = delete;
    DescriptionFile& operator=(const DescriptionFile&) = delete;

    // "de1sim", "run", "--description", the path; the first word is this program's own file.
    std::vector<std::string> command() const;

private:
    int descriptor_;
};

}  // namespace sim
