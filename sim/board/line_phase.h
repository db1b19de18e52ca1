// line_phase.h - where between two samples a line has really begun
//
// Of an edge that is seen in a sample it is only known that it came after the sample before.  But
// lines are equally long: from many of them, of a length that is no whole number of samples, the
// fraction follows, as a monitor's PLL finds it.  Where lines are whole numbers it stays half.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace sim {

class LinePhase {
public:
    // `line`: mean length in samples.
    explicit LinePhase(double line) : line_{line} {}

    // The edge of a line, any number of lines after the one before, was seen in sample number
    // `sample`.  Returns by how much of a sample it came before that, 0 to 1.
    double edge(std::uint64_t sample) {
        if (known_) {
            const auto passed = static_cast<double>(sample - last_);
            early_ = std::clamp(early_ + std::remainder(passed, line_), 0.0, 1.0);
        }
        known_ = true;
        last_ = sample;
        return early_;
    }

private:
    double line_;
    bool known_ = false;  // there was an edge
    std::uint64_t last_ = 0;
    double early_ = 0.5;
};

}  // namespace sim
