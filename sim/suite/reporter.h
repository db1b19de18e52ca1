// reporter.h - what a person sees of `de1sim test`: a line per scenario, the failures last
#pragma once

#include <chrono>
#include <cstddef>
#include <filesystem>
#include <vector>

#include "sim/suite/cases.h"
#include "sim/suite/results.h"

namespace sim::suite {

class Reporter {
public:
    // `jobs` of these cases run at once.
    Reporter(const std::vector<Case>& cases, unsigned jobs);

    void done(const Result& result);
    double wall_s() const;

private:
    double left_s() const;

    const std::size_t count_;
    const unsigned jobs_;
    const bool terminal_;
    const std::chrono::steady_clock::time_point begin_;
    double expected_left_s_ = 0, expected_done_s_ = 0, measured_s_ = 0;
    std::vector<Case> cases_;  // by name
    std::size_t done_ = 0, failed_ = 0;
};

// The failures, each with its steps, expected and found, then a line on stdout: how many passed.
// False, with a line on stderr, if stdout could not be written.
[[nodiscard]] bool summarise(const Results& results, double wall_s,
                             const std::filesystem::path& out);

}  // namespace sim::suite
