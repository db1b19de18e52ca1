// step_reader.h - steps that arrive one by one, and are checked as if they stood in one file.
#pragma once

#include <string_view>

#include "sim/scenario/scenario.h"
#include "sim/scenario/static_checks.h"

namespace sim {

class StepReader {
public:
    // The steps follow those of the scenario, which must outlive this.
    explicit StepReader(const Scenario& scenario);

    // One step in YAML, or in JSON, which is YAML too: {hold: {keypad: "1"}}.  Its line is its
    // number among those that were read.  std::runtime_error, "expected ..., got ...".
    ScenarioStep read(std::string_view text);

private:
    const Scenario& scenario_;
    StaticChecks checks_;
    int number_ = 0;
};

}  // namespace sim
