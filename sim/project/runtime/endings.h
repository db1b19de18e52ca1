// endings.h - how a design ends the run: Verilator's functions for $finish, $stop and errors.
//
// The library that designs are linked with is compiled without these (VL_USER_FINISH ...).  To be
// included once.
#pragma once

#include <cstdint>
#include <cstdio>
#include <cstring>
#include <stdexcept>
#include <string>

#include "verilated.h"

#include "sim/project/model.h"

namespace sim::project {

// Thrown through the design's evaluation, which cannot be continued.
class Diverged : public std::runtime_error {
    using std::runtime_error::runtime_error;
};

// Of the design that is evaluated.
inline Ending* current_ending = nullptr;
inline void (*current_say)(const char* line) = nullptr;
inline std::uint64_t current_time_ps = 0;

inline std::string at_this_time() {
    char text[40];
    std::snprintf(text, sizeof text, ", at %.9f s", static_cast<double>(current_time_ps) * 1e-12);
    return text;
}

// The first one counts.
inline void end_run(Ending::Kind kind, const std::string& message) {
    if (!current_ending || current_ending->kind != Ending::Kind::NONE) return;
    *current_ending = {kind, message + at_this_time()};
}

}  // namespace sim::project

void vl_finish(const char* file, int line, const char*) VL_MT_UNSAFE {
    sim::project::end_run(sim::project::Ending::Kind::FINISHED,
                          std::string{file} + ":" + std::to_string(line) + ": $finish");
}

void vl_stop(const char* file, int line, const char*) VL_MT_UNSAFE {
    sim::project::end_run(sim::project::Ending::Kind::STOPPED,
                          std::string{file} + ":" + std::to_string(line) +
                              ": the design has stopped the run ($stop, $error or $fatal)");
}

void vl_fatal(const char* file, int line, const char*, const char* message) VL_MT_UNSAFE {
    throw sim::project::Diverged{std::string{message ? message : ""} + " (" + (file ? file : "") +
                                 ":" + std::to_string(line) + ")"};
}

void vl_warn(const char* file, int line, const char*, const char* message) VL_MT_UNSAFE {
    if (std::strstr(message, "file not found")) return;  // said by de1sim_init_path
    if (sim::project::current_say)
        sim::project::current_say(
            (std::string{file} + ":" + std::to_string(line) + ": " + message).c_str());
}
