// private_timer.h - the Cortex-A9 MPCore's private timer and watchdog, 200 MHz.
//
//   timer     +0x00 load +0x04 counter +0x08 control +0x0C status
//   watchdog  +0x20 load +0x24 counter +0x28 control +0x2C status +0x30 reset status +0x34 disable
//
//   control: E bit 0, auto-reload bit 1, interrupt bit 2, watchdog mode bit 3 (watchdog only),
//   prescaler 15:8.  Period: (prescaler + 1) * (load + 1) / 200 MHz.
//   status: bit 0, set when the counter reaches 0, cleared by writing 1.
//
// Writing the load writes the counter too.  In watchdog mode the counter's end asks for a reset;
// the mode is left by writing 0x12345678, then 0x87654321 to the disable register.
//
// Source: ARM DDI 0407G, chapter 4.
#pragma once

#include <functional>

#include "sim/hps/alarm.h"
#include "sim/hps/countdown.h"
#include "sim/hps/registers.h"

namespace sim {

// One of the two counters.
class PrivateCounter {
public:
    std::uint32_t control = 0;

    void write_load(std::uint32_t value, std::uint64_t now_ps);
    void write_counter(std::uint32_t value, std::uint64_t now_ps);
    void write_control(std::uint32_t value, std::uint64_t now_ps);
    void clear(std::uint64_t now_ps);

    std::uint32_t load() const { return load_; }
    std::uint32_t count(std::uint64_t now_ps) const { return countdown_.count(now_ps); }
    RunningCount running(std::uint64_t now_ps) const { return countdown_.running(now_ps); }
    bool status(std::uint64_t now_ps) const { return countdown_.zeros(now_ps) > seen_ || status_; }
    bool line(std::uint64_t now_ps) const { return (control & 4) && status(now_ps); }
    // When the status will be set next; no value if it is set or never will be.
    std::optional<std::uint64_t> next_ps(std::uint64_t now_ps) const;

private:
    void restart(std::uint32_t value, std::uint64_t now_ps);

    Countdown countdown_;
    std::uint32_t load_ = 0;
    std::uint64_t seen_ = 0;  // zeros whose status was cleared
    bool status_ = false;     // from before the counter was set
};

class PrivateTimer : public Registers {
public:
    using Line = std::function<void(bool up)>;

    PrivateTimer(const sc_core::sc_module_name& module_name, Line timer, Line watchdog,
                 std::function<void()> reset);

    // The timer's counter.
    RunningCount running(std::uint64_t now_ps) const { return timer_.running(now_ps); }

private:
    std::uint32_t read(std::uint32_t offset, const sc_core::sc_time& now) override;
    void write(std::uint32_t offset, std::uint32_t value, const sc_core::sc_time& now) override;
    void write_watchdog(std::uint32_t offset, std::uint32_t value, std::uint64_t now_ps);
    void update(std::uint64_t now_ps);

    PrivateCounter timer_, watchdog_;
    bool was_reset_ = false;
    bool polled_ = false;        // the program reads a status, so it waits for its change
    std::uint32_t disable_ = 0;  // what was written last
    Line timer_line_, watchdog_line_;
    std::function<void()> reset_;
    Alarm alarm_;
};

}  // namespace sim
