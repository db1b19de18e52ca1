// endings.h - how a design ends the run: Verilator's functions for $finish, $stop and errors.
//
// The library that designs are linked with is compiled without these (VL_USER_FINISH ...).
#pragma once

#include <cstdint>
#include <stdexcept>
#include <string>

#include "sim/project/model.h"

namespace sim::project {

using Ending = FpgaModel::Ending;

// Thrown through the design's evaluation, which cannot be continued.
class Diverged : public std::runtime_error {
    using std::runtime_error::runtime_error;
};

// The design that is evaluated: its ending, which is null after the last one, and who is notified.
struct Evaluated {
    Ending* ending = nullptr;
    void (*report)(const char* line) = nullptr;
    std::uint64_t time_ps = 0;
};
extern Evaluated evaluated;

// The first one counts.
void end_run(Ending::Kind kind, const std::string& message);

}  // namespace sim::project
