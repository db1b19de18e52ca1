// hps_timer.h - one of the HPS's four timers (Synopsys DW_apb_timers), at 100 or 25 MHz.
//
//   +0x00 load count   +0x04 current value   +0x08 control: enable bit 0, mode bit 1 (1: from the
//   load count, 0: from 0xFFFFFFFF after the first), interrupt mask bit 2 (1: off)
//   +0x0C EOI: reading clears   +0x10 interrupt status, masked
//   +0xA0 status   +0xA4 EOI   +0xA8 raw status   +0xAC version
//
// The counter starts from the load count when enable goes from 0 to 1; writing 0 to it clears the
// interrupt.
// Period: load + 1 clocks.
//
// Source: Cyclone V Hard Processor System Technical Reference Manual, chapter Timer.
#pragma once

#include <functional>

#include "sim/hps/alarm.h"
#include "sim/hps/countdown.h"
#include "sim/hps/registers.h"

namespace sim {

class HpsTimer : public Registers {
public:
    HpsTimer(const sc_core::sc_module_name& module_name, std::uint64_t hz,
             std::function<void(bool up)> line);

    // The current value.
    RunningCount running(std::uint64_t now_ps) const { return countdown_.running(now_ps); }

private:
    enum Offset : std::uint32_t;  // of a register
    enum Bit : std::uint32_t;     // of CONTROL

    std::uint32_t read(std::uint32_t offset, const sc_core::sc_time& now) override;
    void write(std::uint32_t offset, std::uint32_t value, const sc_core::sc_time& now) override;
    bool raw(std::uint64_t now_ps) const { return raised_ || countdown_.zeros(now_ps) > seen_; }
    bool status(std::uint64_t now_ps) const;
    void restart(std::uint32_t value, std::uint64_t now_ps);
    void update(std::uint64_t now_ps);

    const std::uint64_t tick_ps_;
    Countdown countdown_;
    std::uint32_t load_ = 0, control_ = 0;
    std::uint64_t seen_ = 0;  // zeros that were cleared
    bool raised_ = false;     // from before the counter was set
    std::function<void(bool)> line_;
    Alarm alarm_;
};

}  // namespace sim
