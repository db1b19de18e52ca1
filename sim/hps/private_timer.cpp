#include "sim/hps/private_timer.h"

#include <algorithm>
#include <utility>

namespace sim {

namespace {

constexpr std::uint64_t TICK_PS = 5000;  // 200 MHz
constexpr std::uint32_t LOAD = 0x00, COUNTER = 0x04, CONTROL = 0x08, STATUS = 0x0C;
constexpr std::uint32_t WATCHDOG = 0x20, RESET_STATUS = 0x30, DISABLE = 0x34;
constexpr std::uint32_t ENABLE = 1, AUTO_RELOAD = 2, INTERRUPT = 4, WATCHDOG_MODE = 8;
constexpr std::uint32_t CONTROL_BITS = 0xFF00 | ENABLE | AUTO_RELOAD | INTERRUPT;
constexpr std::uint32_t FIRST_KEY = 0x12345678, SECOND_KEY = 0x87654321;

}  // namespace

// ---- One counter --------------------------------------------------------------------------------

void PrivateCounter::restart(std::uint32_t value, std::uint64_t now_ps) {
    status_ = status(now_ps);
    seen_ = 0;
    countdown_.set(now_ps, value, TICK_PS * ((control >> 8 & 0xFF) + 1), control & ENABLE,
                   control & AUTO_RELOAD ? std::optional<std::uint32_t>{load_} : std::nullopt);
}

void PrivateCounter::write_load(std::uint32_t value, std::uint64_t now_ps) {
    load_ = value;
    restart(value, now_ps);
}

void PrivateCounter::write_counter(std::uint32_t value, std::uint64_t now_ps) {
    restart(value, now_ps);
}

void PrivateCounter::write_control(std::uint32_t value, std::uint64_t now_ps) {
    const std::uint32_t now = count(now_ps);
    const bool starts = (value & ENABLE) && !(control & ENABLE);
    control = value;
    // A counter that is started at 0 reloads first.
    restart(starts && now == 0 && (value & AUTO_RELOAD) ? load_ : now, now_ps);
}

void PrivateCounter::clear(std::uint64_t now_ps) {
    seen_ = countdown_.zeros(now_ps);
    status_ = false;
}

std::optional<std::uint64_t> PrivateCounter::next_ps(std::uint64_t now_ps) const {
    if (status(now_ps)) return {};
    return countdown_.zero_ps(seen_ + 1);
}

// ---- The pair -----------------------------------------------------------------------------------

PrivateTimer::PrivateTimer(const sc_core::sc_module_name& module_name, Line timer, Line watchdog,
                           std::function<void()> reset)
    : Registers{module_name},
      timer_line_{std::move(timer)},
      watchdog_line_{std::move(watchdog)},
      reset_{std::move(reset)},
      alarm_{"alarm", [this] { update(sc_core::sc_time_stamp().value()); }} {}

std::uint32_t PrivateTimer::read(std::uint32_t offset, const sc_core::sc_time& now) {
    const PrivateCounter& counter = offset < WATCHDOG ? timer_ : watchdog_;
    switch (offset) {
        case LOAD:
        case WATCHDOG + LOAD: return counter.load();
        case COUNTER:
        case WATCHDOG + COUNTER: return counter.count(now.value());
        case CONTROL:
        case WATCHDOG + CONTROL: return counter.control;
        case STATUS:
        case WATCHDOG + STATUS:
            if (!std::exchange(polled_, true)) update(now.value());
            return counter.status(now.value());
        case RESET_STATUS: return was_reset_;
        default: return 0;
    }
}

void PrivateTimer::write(std::uint32_t offset, std::uint32_t value, const sc_core::sc_time& now) {
    const std::uint64_t now_ps = now.value();
    switch (offset) {
        case LOAD: timer_.write_load(value, now_ps); break;
        case COUNTER: timer_.write_counter(value, now_ps); break;
        case CONTROL: timer_.write_control(value & CONTROL_BITS, now_ps); break;
        case STATUS:
            if (value & 1) timer_.clear(now_ps);
            break;
        default: write_watchdog(offset, value, now_ps); break;
    }
    update(now_ps);
}

void PrivateTimer::write_watchdog(std::uint32_t offset, std::uint32_t value, std::uint64_t now_ps) {
    const std::uint32_t mode = watchdog_.control & WATCHDOG_MODE;
    switch (offset) {
        case WATCHDOG + LOAD: watchdog_.write_load(value, now_ps); break;
        case WATCHDOG + COUNTER:
            if (!mode) watchdog_.write_counter(value, now_ps);
            break;
        case WATCHDOG + CONTROL:
            watchdog_.write_control((value & (CONTROL_BITS | WATCHDOG_MODE)) | mode, now_ps);
            break;
        case WATCHDOG + STATUS:
            if (value & 1) watchdog_.clear(now_ps);
            break;
        case RESET_STATUS:
            if (value & 1) was_reset_ = false;
            break;
        case DISABLE:
            if (disable_ == FIRST_KEY && value == SECOND_KEY)
                watchdog_.write_control(watchdog_.control & ~WATCHDOG_MODE, now_ps);
            disable_ = value;
            break;
        default: break;
    }
}

void PrivateTimer::update(std::uint64_t now_ps) {
    timer_line_(timer_.line(now_ps));
    const bool mode = watchdog_.control & WATCHDOG_MODE;
    watchdog_line_(!mode && watchdog_.line(now_ps));
    if (mode && watchdog_.status(now_ps)) {
        watchdog_ = {};
        was_reset_ = true;
        reset_();
    }
    // Only a change that somebody sees needs an event.
    std::optional<std::uint64_t> next;
    if (polled_ || (timer_.control & INTERRUPT)) next = timer_.next_ps(now_ps);
    if (polled_ || mode || (watchdog_.control & INTERRUPT)) {
        const std::optional<std::uint64_t> other = watchdog_.next_ps(now_ps);
        if (other) next = next ? std::min(*next, *other) : other;
    }
    alarm_.set(next);
}

}  // namespace sim
