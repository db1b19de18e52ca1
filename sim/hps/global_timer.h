// global_timer.h - the Cortex-A9 MPCore's global timer: 64 bits that count at 200 MHz.
//
//   +0x0 low word   +0x4 high word   +0x8 control (bit 0: enable)
//
// PERIPHCLK is a quarter of the processor's 800 MHz.  Read high, low, high to get all 64 bits.
//
// Not handled: comparator, auto-increment, prescaler, banked copies: the other registers read 0.
#pragma once

#include "sim/hps/registers.h"

namespace sim {

class GlobalTimer : public Registers {
public:
    explicit GlobalTimer(const sc_core::sc_module_name& module_name) : Registers{module_name} {}

private:
    std::uint32_t read(std::uint32_t offset, const sc_core::sc_time& now) override;
    void write(std::uint32_t offset, std::uint32_t value, const sc_core::sc_time& now) override;
    std::uint64_t count(const sc_core::sc_time& now) const;

    bool enabled_ = false;
    std::uint64_t base_ = 0;         // count when it was last enabled, disabled or written
    std::uint64_t since_ticks_ = 0;  // and the time of that
};

}  // namespace sim
