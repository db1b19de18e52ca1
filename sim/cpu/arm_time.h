// arm_time.h - the time of the A9's program that runs ahead of SystemC's, by its instructions
//
// An instruction takes CPI clocks of 800 MHz.  The A9 issues up to two instructions per clock, and
// in other clocks it waits for its caches.  Neither is modelled, and 1 is a value between the two.
// The CPI of a real program is cycles / instructions, measured on the board with the PMU.
#pragma once

#include <cmath>
#include <cstdint>

#include "sim/cpu/arm_core.h"
#include "sim/cpu/run_ahead_time.h"

namespace sim {

class ArmTime : public RunAheadTime<ArmCore, &ArmCore::instructions> {
public:
    // `cpi`: 0.1 to 100; an instruction's time is rounded to whole picoseconds.
    ArmTime(const ArmCore& core, double cpi)
        : RunAheadTime{core, static_cast<std::uint64_t>(std::llround(CLOCK_PS * cpi))} {}

    std::uint64_t instruction_ps() const { return unit_ps(); }

private:
    static constexpr double CLOCK_PS = 1250;  // 800 MHz
};

}  // namespace sim
