// verilator.h - the Verilator of this machine, and the library that its models run on.
#pragma once

#include <filesystem>
#include <string>

#include "sim/project/tools.h"

namespace sim::project {

struct Verilator {
    std::string version;            // "5.006"
    std::filesystem::path include;  // the folder of verilated.h
};

// ProjectError: there is none on the PATH, or one older than 5.006.
Verilator find_verilator(const TimeLimit& limit);

// What designs are linked with: Verilator's library of that version, and runtime/model.cpp.  That
// of the version with which de1sim was built comes with de1sim; that of another is compiled once,
// in about 10 s, into the user's cache.  ProjectError.
std::filesystem::path runtime_library(const Verilator& verilator, const TimeLimit& limit);

}  // namespace sim::project
