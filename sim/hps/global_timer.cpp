#include "sim/hps/global_timer.h"

#include <utility>

namespace sim {

namespace {

constexpr std::uint64_t PERIPHCLK_PS = 5000;  // 200 MHz

std::uint64_t with_low(std::uint64_t value, std::uint32_t low) {
    return (value & ~0xffffffffull) | low;
}
std::uint64_t with_high(std::uint64_t value, std::uint32_t high) {
    return (value & 0xffffffffull) | static_cast<std::uint64_t>(high) << 32;
}

}  // namespace

enum GlobalTimer::Offset : std::uint32_t {
    LOW = 0x00,
    HIGH = 0x04,
    CONTROL = 0x08,
    STATUS = 0x0C,
    COMPARATOR_LOW = 0x10,
    COMPARATOR_HIGH = 0x14,
    INCREMENT = 0x18
};
enum GlobalTimer::Bit : std::uint32_t {
    ENABLE = 1,
    COMPARE = 2,
    INTERRUPT = 4,
    AUTO_INCREMENT = 8
};

GlobalTimer::GlobalTimer(const sc_core::sc_module_name& module_name, std::function<void(bool)> line)
    : Registers{module_name}, line_{std::move(line)}, alarm_{"alarm", [this] {
                                                                 update(sc_core::sc_time_stamp()
                                                                            .value());
                                                             }} {}

std::uint64_t GlobalTimer::tick_ps() const { return PERIPHCLK_PS * ((control_ >> 8 & 0xFF) + 1); }

std::uint64_t GlobalTimer::count(std::uint64_t now_ps) const {
    if (!(control_ & ENABLE)) return base_;
    return base_ + now_ps / tick_ps() - since_ps_ / tick_ps();
}

RunningCount GlobalTimer::running(bool high, std::uint64_t now_ps) const {
    const std::uint64_t now = count(now_ps);
    const auto low_word = static_cast<std::uint32_t>(now);
    const std::uint64_t phase_ps = now_ps % tick_ps();
    const bool runs = control_ & ENABLE;
    if (!high) return {low_word, runs, tick_ps(), phase_ps};
    const std::uint64_t left_ps = ((std::uint64_t{1} << 32) - low_word) * tick_ps() - phase_ps;
    return {static_cast<std::uint32_t>(now >> 32), 0, 1, 0,
            runs ? left_ps : RunningCount::FOR_EVER};
}

std::uint32_t GlobalTimer::read(std::uint32_t offset, const sc_core::sc_time& now) {
    update(now.value());
    switch (offset) {
        case LOW: return static_cast<std::uint32_t>(count(now.value()));
        case HIGH: return static_cast<std::uint32_t>(count(now.value()) >> 32);
        case CONTROL: return control_;
        case STATUS:
            if (!std::exchange(polled_, true)) update(now.value());
            return status_;
        case COMPARATOR_LOW: return static_cast<std::uint32_t>(comparator_);
        case COMPARATOR_HIGH: return static_cast<std::uint32_t>(comparator_ >> 32);
        case INCREMENT: return increment_;
        default: return 0;
    }
}

void GlobalTimer::write(std::uint32_t offset, std::uint32_t value, const sc_core::sc_time& now) {
    update(now.value());
    base_ = count(now.value());
    since_ps_ = now.value();
    switch (offset) {
        case LOW: base_ = with_low(base_, value); break;
        case HIGH: base_ = with_high(base_, value); break;
        case CONTROL: control_ = value & 0xFF0F; break;
        case STATUS: status_ = status_ && !(value & 1); break;
        case COMPARATOR_LOW: comparator_ = with_low(comparator_, value); break;
        case COMPARATOR_HIGH: comparator_ = with_high(comparator_, value); break;
        case INCREMENT: increment_ = value; break;
        default: break;
    }
    update(now.value());
}

void GlobalTimer::update(std::uint64_t now_ps) {
    const std::uint64_t now = count(now_ps);
    const bool compares = (control_ & ENABLE) && (control_ & COMPARE);
    if (compares && now >= comparator_) {
        status_ = true;
        if ((control_ & AUTO_INCREMENT) && increment_ > 0)
            comparator_ += (now - comparator_) / increment_ * increment_ + increment_;
    }
    line_(status_ && (control_ & INTERRUPT));
    // Rings when the comparator is reached, if somebody will see that.
    const bool waits =
        compares && (polled_ || (control_ & INTERRUPT)) && !status_ && comparator_ > now;
    if (waits && comparator_ - now < (std::uint64_t{1} << 40)) {
        const std::uint64_t ticks = since_ps_ / tick_ps() + (comparator_ - base_);
        alarm_.set(ticks * tick_ps());
    } else {
        alarm_.set({});
    }
}

}  // namespace sim
