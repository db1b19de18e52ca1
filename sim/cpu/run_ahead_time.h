// run_ahead_time.h - the time of a program that runs ahead of SystemC's: what the core has done,
// and waits beside.
#pragma once

#include <algorithm>
#include <cstdint>

#include <systemc>

namespace sim {

// DONE counts what the core has done, in units of `unit_ps`: instructions, or clocks.
template <class Core, std::uint64_t (Core::*DONE)() const>
class RunAheadTime {
public:
    RunAheadTime(const Core& core, std::uint64_t unit_ps) : core_{core}, unit_ps_{unit_ps} {}

    std::uint64_t unit_ps() const { return unit_ps_; }

    // The program's: SystemC's, plus what it is ahead, plus what is not accounted yet.
    sc_core::sc_time now() const {
        return sc_core::sc_time_stamp() + ahead_ + time_of((core_.*DONE)() - accounted_);
    }
    // Of SystemC's, as far as it is accounted.  A bus access adds to it.
    sc_core::sc_time& ahead() { return ahead_; }
    const sc_core::sc_time& ahead() const { return ahead_; }

    // Adds what the core has done since the last call.
    void account() {
        const std::uint64_t done = (core_.*DONE)() - accounted_;
        accounted_ += done;
        ahead_ += time_of(done);
    }
    // The core has counted units whose time is in ahead() already.
    void skip(std::uint64_t units) { accounted_ += units; }

    // How far it may be ahead: to SystemC's next event or the alarm, but 100 us at most.
    sc_core::sc_time horizon() const {
        static const sc_core::sc_time longest{100, sc_core::SC_US};
        const sc_core::sc_time to_event = std::min(sc_core::sc_time_to_pending_activity(), longest);
        if (alarm_ == sc_core::sc_max_time()) return to_event;
        const sc_core::sc_time stamp = sc_core::sc_time_stamp();
        return alarm_ > stamp ? std::min(to_event, alarm_ - stamp) : sc_core::SC_ZERO_TIME;
    }
    bool is_at_horizon() const { return ahead_ >= horizon(); }
    // Units until then.
    std::uint64_t budget() const {
        const sc_core::sc_time end = horizon();
        if (end <= ahead_) return 0;
        return ((end - ahead_).value() + unit_ps_ - 1) / unit_ps_;
    }

    void set_alarm(const sc_core::sc_time& at) { alarm_ = at; }
    const sc_core::sc_time& alarm() const { return alarm_; }

private:
    sc_core::sc_time time_of(std::uint64_t units) const {
        return sc_core::sc_time::from_value(units * unit_ps_);
    }

    const Core& core_;
    const std::uint64_t unit_ps_;
    sc_core::sc_time ahead_, alarm_ = sc_core::sc_max_time();
    std::uint64_t accounted_ = 0;  // units
};

}  // namespace sim
