// reset_manager.h - the HPS's reset manager: what is in reset, and the warm reset.
//
//   +0x00 stat: why the last resets were, write 1 clears: bit 2 a cold one and bit 9 a warm one by
//   the FPGA, bit 4 a cold one and bit 10 a warm one by software, bit 12 the processor's watchdog,
//   14 and 15 the watchdogs on the L4 bus, 18 a debug reset by the FPGA
//   +0x04 ctrl: bit 0 cold, bit 1 warm
//   +0x10 mpumodrst: bit 1: the second processor
//   +0x14 permodrst: 1 = in reset: bits 6 and 7 the watchdogs, 12 - 15 I2C, 16 and 17 the UARTs,
//   18 and 19 the SPI masters, 20 and 21 the SPI slaves, 28 the DMA controller
//   +0x1C brgmodrst: 1 = in reset: bit 0 h2f, bit 1 lwh2f, bit 2 f2h.  All others remember.
//
// After power-on all bridges and all blocks are out of reset, as the boot loader leaves them; the
// second processor is in reset.  A cold reset acts as a warm one: memory and the FPGA keep their
// contents.
//
// Source: Cyclone V HPS TRM, chapter Reset Manager.
//
// Not handled: that a block in reset does not answer; resets of other blocks than the above, which
// remember.
#pragma once

#include <functional>
#include <map>

#include "sim/hps/registers.h"

namespace sim {

class ResetManager : public Registers {
public:
    static constexpr std::uint32_t H2F = 1, LWH2F = 2, F2H = 4;
    enum Cause : std::uint32_t {  // of stat
        COLD_BY_FPGA = 1 << 2,
        COLD_BY_SOFTWARE = 1 << 4,
        WARM_BY_FPGA = 1 << 9,
        WARM_BY_SOFTWARE = 1 << 10,
        MPU_WATCHDOG = 1 << 12,
        L4_WATCHDOG_0 = 1 << 14,
        L4_WATCHDOG_1 = 1 << 15,
        DEBUG_BY_FPGA = 1 << 18
    };

    struct Wires {
        std::function<void(std::uint32_t brgmodrst)> bridges;  // when it is written
        std::function<void(std::uint32_t permodrst)> blocks;   // ... those that go into reset
        std::function<void()> second_processor;                // is released
        std::function<void(bool cold)> reset;                  // is asked for
    };
    ResetManager(const sc_core::sc_module_name& module_name, Wires wires)
        : Registers{module_name}, wires_{std::move(wires)} {}

    void reset(Cause cause) {
        values_[STAT] |= cause;
        if (cause == DEBUG_BY_FPGA) return;  // of what the program does not see
        values_[MPUMODRST] |= CPU1;
        wires_.reset(cause == COLD_BY_SOFTWARE || cause == COLD_BY_FPGA);
    }

    std::uint32_t bridges_in_reset() const {
        const auto found = values_.find(BRGMODRST);
        return found == values_.end() ? 0 : found->second;
    }

private:
    static constexpr std::uint32_t STAT = 0x00, CTRL = 0x04, MPUMODRST = 0x10, PERMODRST = 0x14,
                                   BRGMODRST = 0x1C;
    static constexpr std::uint32_t COLD = 1, WARM = 2, CPU1 = 2;

    std::uint32_t read(std::uint32_t offset, const sc_core::sc_time&) override {
        const auto found = values_.find(offset);
        return found == values_.end() ? 0 : found->second;
    }
    void write(std::uint32_t offset, std::uint32_t value, const sc_core::sc_time&) override {
        if (offset == STAT) {
            values_[STAT] &= ~value;
        } else if (offset == CTRL) {
            if (value & (COLD | WARM)) reset(value & COLD ? COLD_BY_SOFTWARE : WARM_BY_SOFTWARE);
        } else if (offset == BRGMODRST) {
            values_[BRGMODRST] = value & (H2F | LWH2F | F2H);
            wires_.bridges(values_[BRGMODRST]);
        } else if (offset == PERMODRST) {
            wires_.blocks(value & ~values_[PERMODRST]);
            values_[PERMODRST] = value;
        } else if (offset == MPUMODRST) {
            if (values_[MPUMODRST] & ~value & CPU1) wires_.second_processor();
            values_[MPUMODRST] = value;
        } else {
            values_[offset] = value;
        }
    }

    Wires wires_;
    std::map<std::uint32_t, std::uint32_t> values_{{MPUMODRST, CPU1}};
};

}  // namespace sim
