// inspectors.h - who looks at the program while it runs (arm_core.h).
#pragma once

#include <cstdint>
#include <unordered_set>

#include "sim/cpu/arm_core.h"

namespace sim {

struct Inspectors {
    ArmProbe* probe = nullptr;
    std::unordered_set<std::uint32_t> probed;  // where it is asked
    ArmTally* tally = nullptr;
    ArmWatch* watch = nullptr;

    bool is_probed(std::uint32_t pc) const { return !probed.empty() && probed.count(pc); }
    bool has_any() const { return probe || tally || watch; }
};

}  // namespace sim
