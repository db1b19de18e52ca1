#include "sim/profile/frame_budget.h"

#include <algorithm>

#include "sim/text/seconds.h"

namespace sim {

namespace {

template <class Value>
RunReport::Spread spread(const std::vector<Value>& all, double Value::*member) {
    std::vector<double> values;
    for (const Value& one : all) values.push_back(one.*member);
    if (values.empty()) return {};
    std::sort(values.begin(), values.end());
    return {values.front(), values[values.size() / 2], values.back()};
}

}  // namespace

void FrameBudget::frame_ended(const ProgramCpu::Counts& counts, const sc_core::sc_time& now) {
    if (begun_ && now > last_time_ && frames_.size() < MOST) {
        const double time = seconds(now - last_time_);
        const double asleep = seconds(counts.asleep) - seconds(last_.asleep);
        const double on_bus = seconds(counts.on_bus) - seconds(last_.on_bus);
        frames_.push_back({seconds(now),
                           static_cast<double>(counts.instructions - last_.instructions),
                           std::clamp(1 - asleep / time, 0.0, 1.0), on_bus / time});
    }
    begun_ = true;
    last_ = counts;
    last_time_ = now;
}

RunReport::FrameFigures FrameBudget::figures() const {
    return {frames_.size(), spread(frames_, &FrameUse::instructions),
            spread(frames_, &FrameUse::busy_share), spread(frames_, &FrameUse::bus_share)};
}

}  // namespace sim
