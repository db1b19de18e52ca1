// l4_watchdog.h - one of the HPS's two watchdogs on the L4 bus (Synopsys DW_apb_wdt), at 25 MHz
//
//   +0x00 control: enable bit 0, which only a reset of the block clears; mode bit 1 (0: reset the
//   board at the end; 1: interrupt, then reset it at the next end), pulse length bits 4:2
//   +0x04 range: bits 3:0 after a kick, 7:4 at first; n is 65536 << n clocks
//   +0x08 current value   +0x0C restart: writing 0x76 kicks   +0x10 interrupt status
//   +0x14 EOI: reading clears the interrupt   +0xE4 - 0xFC parameters, version, type
//
// After the preloader it is off, as after a reset.
//
// Source: Cyclone V HPS TRM, chapter Watchdog Timer.
//
// Not handled: that the boot ROM starts watchdog 0, and a preloader that leaves it running; the
// pulse's length.
#pragma once

#include <functional>

#include "sim/hps/alarm.h"
#include "sim/hps/countdown.h"
#include "sim/hps/registers.h"

namespace sim {

class L4Watchdog : public Registers {
public:
    // `line`: the interrupt's level; `end` is called when the board is to be reset.
    L4Watchdog(const sc_core::sc_module_name& module_name, std::function<void(bool up)> line,
               std::function<void()> end);

    // As the reset manager resets the block.
    void reset();

private:
    enum Offset : std::uint32_t;  // of a register
    enum Bit : std::uint32_t;     // of CONTROL

    std::uint32_t read(std::uint32_t offset, const sc_core::sc_time& now) override;
    void write(std::uint32_t offset, std::uint32_t value, const sc_core::sc_time& now) override;
    void start(std::uint32_t range, std::uint64_t now_ps);
    void interrupt(bool up);
    void rung();

    std::uint32_t control_ = 0, range_ = 0;
    bool interrupts_ = false;
    Countdown countdown_;
    std::function<void(bool)> line_;
    std::function<void()> end_;
    Alarm alarm_;
};

}  // namespace sim
