// scenario_errors.h - the reader's message about a scenario, "no error" if there is none
#pragma once

#include <filesystem>
#include <string>

#include "sim/scenario/scenario.h"

namespace tb {

inline std::string error_of(const std::string& text) {
    try {
        sim::parse_scenario(text, "a.yaml");
    } catch (const sim::ScenarioError& error) {
        return error.what();
    }
    return "no error";
}

inline std::string load_error(const std::filesystem::path& file) {
    try {
        sim::load_scenario(file);
    } catch (const sim::ScenarioError& error) {
        return error.what();
    }
    return "no error";
}

// Steps begin in line 3; the first key of a step stands in column 3.
inline std::string step_error(const std::string& steps) {
    return error_of("name: a\nversion: 1\nsteps: \n- " + steps);
}

}  // namespace tb
