#include "sim/project/runtime/endings.h"

#include <cstdio>
#include <cstring>

#include "verilated.h"

namespace sim::project {

namespace {

std::string at_this_time() {
    char text[40];
    std::snprintf(text, sizeof text, ", at %.9f s", static_cast<double>(evaluated.time_ps) * 1e-12);
    return text;
}

}  // namespace

Evaluated evaluated;

void end_run(Ending::Kind kind, const std::string& message) {
    Ending* ending = evaluated.ending;
    if (!ending || ending->kind != Ending::Kind::NONE) return;
    *ending = {kind, message + at_this_time()};
}

}  // namespace sim::project

using sim::project::Ending;

void vl_finish(const char* file, int line, const char*) VL_MT_UNSAFE {
    sim::project::end_run(Ending::Kind::FINISHED,
                          std::string{file} + ":" + std::to_string(line) + ": $finish");
}

void vl_stop(const char* file, int line, const char*) VL_MT_UNSAFE {
    sim::project::end_run(Ending::Kind::STOPPED,
                          std::string{file} + ":" + std::to_string(line) +
                              ": the design has stopped the run ($stop, $error or $fatal)");
}

void vl_fatal(const char* file, int line, const char*, const char* message) VL_MT_UNSAFE {
    if (message && std::strstr(message, "$readmem")) {
        const bool too_long = std::strstr(message, "beyond bounds");
        static std::string reported;  // once for each file
        if (too_long && reported == file) return;
        reported = file;
        const std::string what = std::string{file} + ":" + std::to_string(line) + ": ";
        const auto report = sim::project::evaluated.report;
        if (too_long && report)
            report((what + "10850: the file has more words than the array, which are left out")
                       .c_str());
        else if (!too_long)
            sim::project::end_run(Ending::Kind::STOPPED, what + message);
        return;
    }
    throw sim::project::Diverged{std::string{message ? message : ""} + " (" + (file ? file : "") +
                                 ":" + std::to_string(line) + ")"};
}

void vl_warn(const char* file, int line, const char*, const char* message) VL_MT_UNSAFE {
    if (std::strstr(message, "file not found")) return;  // de1sim_init_path has reported it
    if (const auto report = sim::project::evaluated.report)
        report((std::string{file} + ":" + std::to_string(line) + ": " + message).c_str());
}
