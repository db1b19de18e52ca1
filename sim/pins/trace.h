// trace.h - waveforms of the chip: into which file, and of which time.
#pragma once

#include <cstdint>
#include <string>

namespace sim {

struct Trace {
    std::string file = {};  // FST; empty: none
    std::uint64_t from_ps = 0, to_ps = ~std::uint64_t{0};

    bool wants(std::uint64_t time_ps) const { return time_ps >= from_ps && time_ps <= to_ps; }
};

}  // namespace sim
