// frame_budget.h - how much of a frame's time a program uses, from the processor's own counters.
//
// A frame is the time between two ends of frames on the monitor, 16.8 ms.  Costs one reading of the
// counters and 32 bytes per frame.
#pragma once

#include <cstddef>
#include <vector>

#include "sim/cpu/program_cpu.h"
#include "sim/report/report.h"

namespace sim {

class FrameBudget {
public:
    // Later frames are not kept: half an hour of 60 per second, 3 MB.
    static constexpr std::size_t MOST = 100'000;

    void frame_ended(const ProgramCpu::Counts& counts, const sc_core::sc_time& now);
    RunReport::FrameFigures figures() const;
    const std::vector<FrameUse>& frames() const { return frames_; }

private:
    bool begun_ = false;
    ProgramCpu::Counts last_;
    sc_core::sc_time last_time_;
    std::vector<FrameUse> frames_;
};

}  // namespace sim
