// exit_code.h - what de1sim ends with.
#pragma once

namespace sim {

enum ExitCode {
    PASSED = 0,
    FAILED = 1,         // an expectation missed, a firmware fault, a bus error not handled
    WRONG_INPUT = 2,    // usage, scenario, output; also an internal error of the simulator
    INTERRUPTED = 130,  // Ctrl-C; the files so far are whole
};

}  // namespace sim
