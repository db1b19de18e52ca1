// running_count.h - how a counter will go on, for those who know when they will read it.
#pragma once

#include <cstdint>
#include <limits>

namespace sim {

struct RunningCount {
    static constexpr std::uint64_t FOR_EVER = std::numeric_limits<std::uint64_t>::max();

    std::uint32_t value;               // now, modulo 2^32
    int sign;                          // +1: counts up, -1: down, 0: stands
    std::uint64_t tick_ps = 1;         // per step
    std::uint64_t phase_ps = 0;        // since its last step
    std::uint64_t left_ps = FOR_EVER;  // that it goes on so, until it reloads, stands or starts
};

}  // namespace sim
