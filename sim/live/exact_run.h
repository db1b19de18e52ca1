// exact_run.h - the message {"run": ...}: time that passes for a program that plays, and no more.
//
// Ends at a simulated millisecond, so that the same messages give the same run on every machine.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include <systemc>

namespace sim::live {

class ExactRun {
public:
    // How often what a run can wait for has happened.
    struct Counts {
        std::uint64_t frames = 0, pictures = 0, printed = 0, lamps = 0, pins = 0;
        bool steps_are_done = false;  // those of the scenario with which the run began
    };

    // `order`: "20ms", or {"for": "20ms", "until": ["frame", "picture", "printed", "lamps",
    // "pins", "steps"]}.  std::runtime_error, "expected ..., got ...".
    ExactRun(const nlohmann::json& order, const Counts& counts, sc_core::sc_time now);

    bool over(const Counts& counts, sc_core::sc_time now) const;
    // Of those that it waited for, what has happened.
    std::vector<std::string> met(const Counts& counts) const;

private:
    std::vector<std::string> until_;
    Counts before_;
    sc_core::sc_time end_;
};

}  // namespace sim::live
