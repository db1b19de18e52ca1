// report.h - what a run did: report.json for programs, junit.xml for test servers
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "sim/report/part_report.h"
#include "sim/report/tap.h"

namespace sim {

struct Expectation {
    std::string step;   // in words
    int line = 0;       // in the scenario file
    double time_s = 0;  // simulated, when it was decided
    bool met = false;
    std::string detail;  // what was found instead; may be empty when met
};

// How the run came to its end.
enum class RunEnd {
    ALL_STEPS_DONE,
    DURATION_REACHED,
    PROGRAM_ENDED,  // if there is no scenario
    INTERRUPTED,
    FIRMWARE_FAULT,
    DESIGN_STOPPED,     // by $stop, $error or $fatal of a project
    DESIGN_OSCILLATES,  // a project that does not come to rest
    INTERNAL_ERROR,     // of the simulator; the faults say which
};

const char* to_string(RunEnd end);  // "all steps done", ...

// What the program used of the frame that ended at this time; shares of the frame's time.
struct FrameUse {
    double time_s = 0, instructions = 0, busy_share = 0, bus_share = 0;
};

struct RunReport {
    struct Bus {
        std::uint64_t reads = 0, writes = 0, bursts = 0, errors = 0;
    };
    struct Audio {
        double rate_hz = 0;
        std::uint64_t samples = 0, underruns = 0;
    };

    // Minimum, median and maximum of a value over all frames, each from one frame's end to the
    // next.  The first frame, in which the program starts, is left out.  Not in the file if there
    // are none.
    struct Spread {
        double least = 0, median = 0, most = 0;
    };
    struct FrameFigures {
        std::uint64_t count = 0;
        Spread instructions;
        Spread busy_share;  // of the frame's time, not asleep
        Spread bus_share;   // of the frame's time, waiting for registers and FPGA memory
    };

    // What a lamp, a row of digits or a header showed.
    struct Shown {
        using Fields = std::vector<std::pair<std::string, std::string>>;
        std::string name;
        Fields at_end;
        std::vector<std::pair<double, Fields>> changes;  // the first of them, by seconds
        std::uint64_t left_out = 0;                      // later changes
    };

    // Only where a processor runs an ELF.
    struct Program {
        std::string elf;
        double cpi = 0;
        std::uint64_t instructions = 0, interrupts = 0, aborts = 0;
        double asleep_s = 0;                // in WFI and WFE
        double on_bus_s = 0;                // waiting for registers and FPGA memory
        std::uint32_t pc = 0;               // at the end
        std::string function;               // there; empty if it has no name
        std::string waiting;                // "an interrupt", "a change of 0xFF200050", or empty
        std::optional<int> exit_code = {};  // of a program that has ended itself
        std::vector<std::string> network = {};  // outside, that it could reach: "host:port"
        FrameFigures frames = {};
    };

    std::string scenario;  // its name
    std::string file;      // and its path; both empty without one
    std::uint64_t seed = 1;
    std::string cpu;  // "native", "arm" or "nios-v"
    std::optional<Program> program;
    RunEnd end = RunEnd::ALL_STEPS_DONE;

    double simulated_s = 0;
    double wall_s = 0;
    std::uint64_t frames_shown = 0;
    std::uint64_t frames_swapped = 0;
    std::string last_frame_sha256;  // of the RGB bytes; empty when no frame was shown
    std::vector<std::pair<std::uint64_t, std::string>> pictures;  // new ones: frame, its SHA-256
    std::string signal;  // that the monitor has locked on to, or why it has not
    Bus bus;
    Audio audio;
    std::uint64_t key_events = 0;
    std::vector<Shown> shown;
    std::vector<PartReport> parts;        // those that have something to tell
    std::vector<std::string> characters;  // rows of the character buffer, at the end

    std::uint64_t timing_violation_count = 0;
    std::vector<std::string> timing_violations;  // the first 20; more are not printed
    std::uint64_t sdram_violation_count = 0;
    std::vector<std::string> sdram_violations;  // the same
    std::vector<std::string> faults;
    std::uint64_t log_lines = 0;
    std::vector<std::string> log;     // the first of them: aborts that the program handled, resets
    std::string lamps;                // what is lit at the end, in words; for the summary
    std::vector<std::string> advice;  // possible causes of the result; only for the summary
    std::vector<Expectation> expectations;
    std::vector<Check> checks;  // that the program made itself; not in the file if there is none

    bool interrupted() const { return end == RunEnd::INTERRUPTED; }

    // Every expectation and check met, no fault, not interrupted.
    bool passed() const;
};

// What report.json calls `format`.  It changes with the meaning of a key, not when keys are added.
constexpr int REPORT_FORMAT = 1;

// Keys in a fixed order.  Only the key "wall" depends on the machine: without it, two runs of the
// same inputs are equal byte for byte, unless the program had a network.
std::string to_json(const RunReport& report);

// One test case per expectation or check, and one for the run itself.  Faults and an interruption
// make the latter an error.  Times are simulated.
std::string to_junit(const RunReport& report);

}  // namespace sim
