#include "sim/hps/hps_timer.h"

namespace sim {

namespace {

constexpr std::uint64_t PS_PER_S = 1'000'000'000'000;
constexpr std::uint32_t VERSION_2_05 = 0x3230352A;

}  // namespace

enum HpsTimer::Offset : std::uint32_t {
    LOAD = 0x00,
    CURRENT = 0x04,
    CONTROL = 0x08,
    EOI = 0x0C,
    STATUS = 0x10,
    ALL_STATUS = 0xA0,
    ALL_EOI = 0xA4,
    ALL_RAW = 0xA8,
    VERSION = 0xAC
};
enum HpsTimer::Bit : std::uint32_t { ENABLE = 1, USER_DEFINED = 2, MASKED = 4 };

HpsTimer::HpsTimer(const sc_core::sc_module_name& module_name, std::uint64_t hz,
                   std::function<void(bool)> line)
    : Registers{module_name},
      tick_ps_{PS_PER_S / hz},
      line_{std::move(line)},
      alarm_{"alarm", [this] { update(sc_core::sc_time_stamp().value()); }} {}

bool HpsTimer::status(std::uint64_t now_ps) const { return !(control_ & MASKED) && raw(now_ps); }

void HpsTimer::restart(std::uint32_t value, std::uint64_t now_ps) {
    raised_ = raw(now_ps) && (control_ & ENABLE);
    countdown_.set(now_ps, value, tick_ps_, control_ & ENABLE,
                   control_ & USER_DEFINED ? load_ : 0xFFFFFFFF);
    seen_ = 0;
}

std::uint32_t HpsTimer::read(std::uint32_t offset, const sc_core::sc_time& now) {
    const std::uint64_t now_ps = now.value();
    switch (offset) {
        case LOAD: return load_;
        case CURRENT: return countdown_.count(now_ps);
        case CONTROL: return control_;
        case EOI:
        case ALL_EOI:
            seen_ = countdown_.zeros(now_ps);
            raised_ = false;
            update(now_ps);
            return 0;
        case STATUS:
        case ALL_STATUS: return status(now_ps);
        case ALL_RAW: return raw(now_ps);
        case VERSION: return VERSION_2_05;
        default: return 0;
    }
}

void HpsTimer::write(std::uint32_t offset, std::uint32_t value, const sc_core::sc_time& now) {
    const std::uint64_t now_ps = now.value();
    const std::uint32_t count = countdown_.count(now_ps);
    if (offset == LOAD) {
        load_ = value;  // counts from the next reload on
        restart(count, now_ps);
    } else if (offset == CONTROL) {
        const bool starts = (value & ENABLE) && !(control_ & ENABLE);
        control_ = value & 7;
        restart(starts ? load_ : count, now_ps);
    }
    update(now_ps);
}

void HpsTimer::update(std::uint64_t now_ps) {
    line_(status(now_ps));
    const bool waits = !(control_ & MASKED) && !raw(now_ps);
    alarm_.set(waits ? countdown_.zero_ps(seen_ + 1) : std::nullopt);
}

}  // namespace sim
