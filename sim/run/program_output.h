// program_output.h - what the program prints, to stdout as it comes.
//
// A terminal gets it made safe (terminal_text.h), a file or pipe byte for byte.  A line is written
// when it is complete, the beginning of one at flush().
#pragma once

#include <string>

#include "sim/text/terminal_text.h"

namespace sim {

class ProgramOutput {
public:
    // `at_once`: each character as it comes, for a debugger, with whom simulated time stands still.
    explicit ProgramOutput(bool at_once);

    void print(char character);
    void flush();
    void end();  // the last of it

private:
    const bool at_once_, terminal_;
    std::string line_;
    TerminalText text_;
};

}  // namespace sim
