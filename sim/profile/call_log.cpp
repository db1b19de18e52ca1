#include "sim/profile/call_log.h"

#include <algorithm>
#include <limits>

#include <fmt/format.h>

#include "sim/text/seconds.h"

namespace sim {

CallLog::CallLog(Profile& profile, const ProgramCpu& cpu, const sc_core::sc_time& end)
    : profile_{profile} {
    profile.on_call = [this, &cpu, end](std::size_t depth, std::size_t caller, std::size_t callee) {
        const sc_core::sc_time now = cpu.now();
        if (now > end) return;
        calls_.push_back({now, depth, caller, callee});
        if (calls_.size() <= MOST) return;
        calls_.pop_front();
        ++left_out_;
    };
}

std::string CallLog::text() const {
    std::string text =
        fmt::format("# {}: the last {} calls; {} came before\n# time s, function\n",
                    profile_.program().file.filename().string(), calls_.size(), left_out_);
    std::size_t least = std::numeric_limits<std::size_t>::max();
    for (const Call& call : calls_) least = std::min(least, call.depth);
    for (const Call& call : calls_)
        text +=
            fmt::format("{:.9f}  {:{}}{} <- {}\n", seconds(call.time), "", 2 * (call.depth - least),
                        profile_.name(call.callee), profile_.name(call.caller));
    return text;
}

}  // namespace sim
