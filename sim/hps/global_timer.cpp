#include "sim/hps/global_timer.h"

namespace sim {

namespace {

constexpr std::uint64_t TICK_PS = 5000;  // 200 MHz
constexpr std::uint32_t LOW = 0x0, HIGH = 0x4, CONTROL = 0x8;

std::uint64_t ticks(const sc_core::sc_time& time) { return time.value() / TICK_PS; }

}  // namespace

std::uint64_t GlobalTimer::count(const sc_core::sc_time& now) const {
    return enabled_ ? base_ + ticks(now) - since_ticks_ : base_;
}

std::uint32_t GlobalTimer::read(std::uint32_t offset, const sc_core::sc_time& now) {
    switch (offset) {
        case LOW: return static_cast<std::uint32_t>(count(now));
        case HIGH: return static_cast<std::uint32_t>(count(now) >> 32);
        case CONTROL: return enabled_;
        default: return 0;
    }
}

void GlobalTimer::write(std::uint32_t offset, std::uint32_t value, const sc_core::sc_time& now) {
    base_ = count(now);
    since_ticks_ = ticks(now);
    switch (offset) {
        case LOW: base_ = (base_ & ~0xffffffffull) | value; break;
        case HIGH: base_ = (base_ & 0xffffffffull) | static_cast<std::uint64_t>(value) << 32; break;
        case CONTROL: enabled_ = value & 1; break;
        default: break;
    }
}

}  // namespace sim
