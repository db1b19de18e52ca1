// global_timer.h - the Cortex-A9 MPCore's global timer: 64 bits that count at 200 MHz.
//
//   +0x00 low word   +0x04 high word   +0x08 control: enable bit 0, compare bit 1, interrupt bit 2,
//   auto-increment bit 3, prescaler 15:8   +0x0C status: bit 0, cleared by writing 1
//   +0x10 comparator low   +0x14 comparator high   +0x18 auto-increment
//
// PERIPHCLK is a quarter of the processor's 800 MHz.  Read high, low, high to get all 64 bits.  The
// status is set while compare is on and the counter is at or past the comparator.  Auto-increment
// then advances the comparator.
//
// Source: ARM DDI 0407G, 4.3 and 4.4.
//
// Not handled: banked copies for the second processor.
#pragma once

#include <functional>

#include "sim/hps/alarm.h"
#include "sim/hps/registers.h"
#include "sim/hps/running_count.h"

namespace sim {

class GlobalTimer : public Registers {
public:
    GlobalTimer(
        const sc_core::sc_module_name& module_name,
        std::function<void(bool up)> line = [](bool) {});

    // The low or the high word.
    RunningCount running(bool high, std::uint64_t now_ps) const;

private:
    enum Offset : std::uint32_t;  // of a register
    enum Bit : std::uint32_t;     // of CONTROL

    std::uint32_t read(std::uint32_t offset, const sc_core::sc_time& now) override;
    void write(std::uint32_t offset, std::uint32_t value, const sc_core::sc_time& now) override;
    std::uint64_t tick_ps() const;
    std::uint64_t count(std::uint64_t now_ps) const;
    void update(std::uint64_t now_ps);

    std::uint32_t control_ = 0, increment_ = 0;
    std::uint64_t comparator_ = 0;
    bool status_ = false;
    bool polled_ = false;         // the program reads the status, so it waits for its change
    std::uint64_t base_ = 0;      // count when it was last enabled, disabled or written
    std::uint64_t since_ps_ = 0;  // and the time of that
    std::function<void(bool)> line_;
    Alarm alarm_;
};

}  // namespace sim
