// call_log.h - a program's last function calls, with their times.
#pragma once

#include <cstddef>
#include <deque>
#include <string>

#include "sim/cpu/program_cpu.h"
#include "sim/profile/profile.h"

namespace sim {

class CallLog {
public:
    static constexpr std::size_t MOST = 1'000;

    // Listens to the calls that `profile` finds, from now until `end`.  Both others must
    // outlive it.
    CallLog(Profile& profile, const ProgramCpu& cpu, const sc_core::sc_time& end);

    // A line per call, the oldest first: when, then the function, indented by how deep it is, and
    // its caller.
    std::string text() const;

private:
    struct Call {
        sc_core::sc_time time;
        std::size_t depth, caller, callee;
    };
    const Profile& profile_;
    std::deque<Call> calls_;
    std::uint64_t left_out_ = 0;
};

}  // namespace sim
