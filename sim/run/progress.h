// progress.h - how far the run is: a bar on a terminal, else a line every simulated second.
#pragma once

#include <chrono>
#include <cstdint>
#include <optional>

namespace sim {

class Progress {
public:
    // `total_s`: simulated seconds of the run, if they are known.
    Progress(bool quiet, std::optional<double> total_s);

    void show(double simulated_s, std::uint64_t frames);
    void done();  // ends the bar's line

    double wall_s() const;

private:
    const bool quiet_, terminal_;
    const std::optional<double> total_s_;
    const std::chrono::steady_clock::time_point begin_;
    double next_wall_s_ = 0, next_simulated_s_ = 1;
};

}  // namespace sim
