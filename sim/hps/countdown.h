// countdown.h - a counter that counts down to 0 and, if it reloads, starts again.
//
// Nothing is stepped: the count at any time follows from the time at which it was last set.  A
// period with reload is load + 1 ticks: the counter is at 0 for one of them.  With a reload of 0 it
// stays at 0 and does not reach it again.
#pragma once

#include <cstdint>
#include <optional>

#include "sim/hps/running_count.h"

namespace sim {

class Countdown {
public:
    // From `now_ps` on, if `running`: counts down from `value` by one every `tick_ps`.
    void set(std::uint64_t now_ps, std::uint32_t value, std::uint64_t tick_ps, bool running,
             std::optional<std::uint32_t> reload) {
        begin_ps_ = now_ps;
        value_ = value;
        tick_ps_ = tick_ps;
        running_ = running;
        reload_ = reload;
    }

    std::uint32_t count(std::uint64_t now_ps) const {
        const std::uint64_t n = ticks(now_ps);
        if (n <= value_) return value_ - static_cast<std::uint32_t>(n);
        if (!reload_) return 0;
        return *reload_ -
               static_cast<std::uint32_t>((n - value_ - 1) % (std::uint64_t{*reload_} + 1));
    }

    // How it goes on from `now_ps`, at which it has been set already.
    RunningCount running(std::uint64_t now_ps) const {
        const std::uint32_t value = count(now_ps);
        const bool stays = value == 0 && (!reload_ || *reload_ == 0);
        if (!running_ || (stays && ticks(now_ps) > 0)) return {value, 0};
        const std::uint64_t phase_ps = (now_ps - begin_ps_) % tick_ps_;
        return {value, -1, tick_ps_, phase_ps, (std::uint64_t{value} + 1) * tick_ps_ - phase_ps};
    }

    // How often 0 was reached since it was set.
    std::uint64_t zeros(std::uint64_t now_ps) const {
        const std::uint64_t n = ticks(now_ps);
        const std::uint64_t first = value_ > 0 && n >= value_ ? 1 : 0;
        if (!reload_ || *reload_ == 0 || n <= value_) return first;
        return first + (n - value_) / (std::uint64_t{*reload_} + 1);
    }

    // When 0 is reached for the `number`th time (from 1 on); no value if never.
    std::optional<std::uint64_t> zero_ps(std::uint64_t number) const {
        if (!running_) return {};
        const std::uint64_t later = value_ > 0 ? number - 1 : number;
        if (later > 0 && (!reload_ || *reload_ == 0)) return {};
        const std::uint64_t period = reload_ ? std::uint64_t{*reload_} + 1 : 0;
        return begin_ps_ + (value_ + later * period) * tick_ps_;
    }

private:
    std::uint64_t ticks(std::uint64_t now_ps) const {
        return running_ && now_ps > begin_ps_ ? (now_ps - begin_ps_) / tick_ps_ : 0;
    }

    std::uint64_t begin_ps_ = 0, tick_ps_ = 1;
    std::uint32_t value_ = 0;
    bool running_ = false;
    std::optional<std::uint32_t> reload_;
};

}  // namespace sim
