// run_program.h - runs a program to its end, as a shell would, and keeps its output.
#pragma once

#include <csignal>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace tb {

struct Command {
    std::vector<std::string> arguments;           // path and arguments
    std::function<bool()> interrupt_when = {};    // Ctrl-C as soon as this is true
    int interrupt_by = SIGINT;                    // or another signal than Ctrl-C's
    std::string shell = {};                       // commands of a shell before it: "exec 2>&-"
    std::optional<std::uint64_t> disk_full = {};  // no file grows beyond so many bytes
    bool on_terminal = false;                     // stderr is one, of 80 x 24
    double timeout_s = 600;                       // then it is killed as hanging
};

// False where the machine has no terminals to give (/dev/pts is not mounted).
bool has_terminals();

struct Outcome {
    int exit_code = -1;  // minus the signal, if one ended it
    bool timed_out = false;
    std::string out, err;
};

// std::system_error if it cannot be started.
Outcome run_program(const Command& command);

std::vector<std::string> lines_of(const std::string& text);

}  // namespace tb
