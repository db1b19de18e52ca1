#include "sim/profile/frame_budget.h"

#include <algorithm>

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

void FrameBudget::frame_ended(const ArmCpu::Counts& counts, const sc_core::sc_time& now) {
    if (begun_ && now > last_time_ && frames_.size() < MOST) {
        const double time = (now - last_time_).to_seconds();
        const double asleep = counts.asleep.to_seconds() - last_.asleep.to_seconds();
        const double on_bus = counts.on_bus.to_seconds() - last_.on_bus.to_seconds();
        frames_.push_back({now.to_seconds(),
                           static_cast<double>(counts.instructions - last_.instructions),
                           std::clamp(1 - asleep / time, 0.0, 1.0), on_bus / time});
    }
    begun_ = true;
    last_ = counts;
    last_time_ = now;
}

RunReport::FrameFigures FrameBudget::figures() const {
    using page::FrameUse;
    return {frames_.size(), spread(frames_, &FrameUse::instructions),
            spread(frames_, &FrameUse::busy_share), spread(frames_, &FrameUse::bus_share)};
}

}  // namespace sim
