// program_run.h - what a run with an ELF has besides, whichever processor: figures, words for
// reports, why interrupts were not taken.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "sim/cpu/program_cpu.h"
#include "sim/hps/bus.h"
#include "sim/profile/call_log.h"
#include "sim/profile/frame_budget.h"
#include "sim/profile/profile.h"
#include "sim/report/report.h"
#include "sim/run/plan.h"
#include "sim/run/recorder.h"

namespace sim {

class ProgramRun {
public:
    // Attaches to the recorder's frames.
    ProgramRun(ProgramCpu& cpu, const Bus& bus, const RunPlan& plan, Recorder& recorder);
    virtual ~ProgramRun() = default;
    ProgramRun(const ProgramRun&) = delete;
    ProgramRun& operator=(const ProgramRun&) = delete;

    virtual RunReport::Program program() const;
    virtual std::string waiting() const;  // for what, "an interrupt"; or empty
    const std::vector<FrameUse>& frames() const { return budget_.frames(); }
    // A line for each interrupt that was not taken.  Once the run is over, outside simulated time.
    virtual std::vector<std::string> missed_interrupts() { return {}; }

    virtual bool on_linux() const { return false; }
    // Of a Linux program; as LinuxKernel::missing().
    virtual std::vector<std::string> missing_calls() const { return {}; }
    virtual void write_profile();  // if it was asked for; IoError
    // Of a part of the run, or null.
    const CallLog* calls() const { return calls_ ? &*calls_ : nullptr; }

protected:
    // Null where nobody wants to know.
    Profile* profile() { return profile_ ? &*profile_ : nullptr; }

private:
    ProgramCpu& program_cpu_;
    const Bus& program_bus_;
    const std::filesystem::path profile_file_;  // or empty
    FrameBudget budget_;
    std::optional<Profile> profile_;
    std::optional<CallLog> calls_;
};

}  // namespace sim
