// run_command.h - other programs: Verilator, the compiler, Slurm, de1sim itself once more.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace sim {

struct Outcome {
    int code;            // exit code; 127: there is no such program; 128 + n: ended by signal n
    std::string output;  // stdout and stderr

    std::string last_line() const;  // of the output, without its end; or nothing
};

// Runs the program, found on the PATH, in `folder`, without a shell.  After `limit_s` seconds, or
// when `given_up` says so, which is asked five times per second, it is ended with all that it has
// started, and the code is TIMED_OUT.  It also ends with the thread that has called.
constexpr int TIMED_OUT = -1;
Outcome run_command(
    const std::vector<std::string>& command, const std::filesystem::path& folder, unsigned limit_s,
    const std::function<bool()>& given_up = [] { return false; });

// The same for several, as many at once as the machine has processors; outcomes in their order.
std::vector<Outcome> run_commands(const std::vector<std::vector<std::string>>& commands,
                                  const std::filesystem::path& folder, unsigned limit_s);

}  // namespace sim
