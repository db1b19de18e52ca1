// piped_command.h - another program that reads what this one writes
#pragma once

#include <sys/types.h>

#include <string>
#include <vector>

#include "sim/process/run_command.h"

namespace sim {

class PipedCommand {
public:
    // Starts the program, found on the PATH, without a shell and out of reach of the terminal's
    // Ctrl-C.  It also ends with the thread that has called.  std::runtime_error.
    explicit PipedCommand(const std::vector<std::string>& command);
    // Ends it, unless finish() was called.
    ~PipedCommand();
    PipedCommand(const PipedCommand&) = delete;
    PipedCommand& operator=(const PipedCommand&) = delete;

    // To its standard input; waits for it.  False: it reads no more.
    bool write(const std::string& bytes);
    // Closes its input, and waits for its end.  The same again if it is called once more.
    const Outcome& finish();

private:
    pid_t child_ = -1;
    int input_ = -1, output_ = -1;  // pipe to it; file of what it prints
    Outcome outcome_{0, {}};
};

}  // namespace sim
