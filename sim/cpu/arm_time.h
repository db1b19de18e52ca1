// arm_time.h - the time of a program that runs ahead of SystemC's: instructions, and waits beside.
//
// An instruction takes CPI clocks of 800 MHz.  The A9 issues up to two instructions per clock, and
// in other clocks it waits for its caches.  Neither is modelled, and 1 is a value between the two.
// The CPI of a real program is cycles / instructions, measured on the board with the PMU.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include <systemc>

#include "sim/cpu/arm_core.h"

namespace sim {

class ArmTime {
public:
    // `cpi`: 0.1 to 100; an instruction's time is rounded to whole picoseconds.
    ArmTime(const ArmCore& core, double cpi)
        : core_{core}, instruction_ps_{static_cast<std::uint64_t>(std::llround(CLOCK_PS * cpi))} {}

    std::uint64_t instruction_ps() const { return instruction_ps_; }

    // The program's: SystemC's, plus what it is ahead, plus what is not accounted yet.
    sc_core::sc_time now() const {
        return sc_core::sc_time_stamp() + ahead_ + time_of(core_.instructions() - accounted_);
    }
    // Of SystemC's, as far as it is accounted.  A bus access adds to it.
    sc_core::sc_time& ahead() { return ahead_; }
    const sc_core::sc_time& ahead() const { return ahead_; }

    // Adds the instructions that the core has executed since the last call.
    void account() {
        const std::uint64_t done = core_.instructions() - accounted_;
        accounted_ += done;
        ahead_ += time_of(done);
    }
    // The core has counted instructions whose time is in ahead() already.
    void skip(std::uint64_t instructions) { accounted_ += instructions; }

    // How far it may be ahead: to SystemC's next event or the alarm, but 100 us at most.
    sc_core::sc_time horizon() const {
        static const sc_core::sc_time longest{100, sc_core::SC_US};
        const sc_core::sc_time to_event = std::min(sc_core::sc_time_to_pending_activity(), longest);
        if (alarm_ == sc_core::sc_max_time()) return to_event;
        const sc_core::sc_time stamp = sc_core::sc_time_stamp();
        return alarm_ > stamp ? std::min(to_event, alarm_ - stamp) : sc_core::SC_ZERO_TIME;
    }
    bool is_at_horizon() const { return ahead_ >= horizon(); }
    // Instructions until then.
    std::uint64_t budget() const {
        const sc_core::sc_time end = horizon();
        if (end <= ahead_) return 0;
        return ((end - ahead_).value() + instruction_ps_ - 1) / instruction_ps_;
    }

    void set_alarm(const sc_core::sc_time& at) { alarm_ = at; }
    const sc_core::sc_time& alarm() const { return alarm_; }

private:
    static constexpr double CLOCK_PS = 1250;  // 800 MHz

    sc_core::sc_time time_of(std::uint64_t instructions) const {
        return sc_core::sc_time::from_value(instructions * instruction_ps_);
    }

    const ArmCore& core_;
    const std::uint64_t instruction_ps_;
    sc_core::sc_time ahead_, alarm_ = sc_core::sc_max_time();
    std::uint64_t accounted_ = 0;  // instructions
};

}  // namespace sim
