// reset_manager.h - the HPS's reset manager: bridges in and out of reset, and the warm reset.
//
//   +0x00 stat (bit 1: a warm reset by software; write 1 clears)
//   +0x04 ctrl: bit 0 cold, bit 1 warm
//   +0x1C brgmodrst: 1 = in reset: bit 0 h2f, bit 1 lwh2f, bit 2 f2h.  All others remember.
//
// After power-on all bridges are out of reset, as the boot loader leaves them.  A cold reset acts
// as a warm one: memory and the FPGA keep their contents.
//
// Source: Cyclone V HPS TRM, chapter Reset Manager.
//
// Not handled: resets of single peripherals (permodrst and others remember).
#pragma once

#include <functional>
#include <map>

#include "sim/hps/registers.h"

namespace sim {

class ResetManager : public Registers {
public:
    static constexpr std::uint32_t H2F = 1, LWH2F = 2, F2H = 4;

    // `bridges` is called with brgmodrst when it is written, `warm` when a reset is asked for.
    ResetManager(const sc_core::sc_module_name& module_name,
                 std::function<void(std::uint32_t brgmodrst)> bridges, std::function<void()> warm)
        : Registers{module_name}, bridges_{std::move(bridges)}, warm_{std::move(warm)} {}

private:
    static constexpr std::uint32_t STAT = 0x00, CTRL = 0x04, MPUMODRST = 0x10, BRGMODRST = 0x1C;
    static constexpr std::uint32_t WARM_BY_SOFTWARE = 2, CPU1 = 2;

    std::uint32_t read(std::uint32_t offset, const sc_core::sc_time&) override {
        const auto found = values_.find(offset);
        return found == values_.end() ? 0 : found->second;
    }
    void write(std::uint32_t offset, std::uint32_t value, const sc_core::sc_time&) override {
        if (offset == STAT) {
            values_[STAT] &= ~value;
        } else if (offset == CTRL) {
            if (!(value & 3)) return;
            values_[STAT] |= WARM_BY_SOFTWARE;
            warm_();
        } else if (offset == BRGMODRST) {
            values_[BRGMODRST] = value & (H2F | LWH2F | F2H);
            bridges_(values_[BRGMODRST]);
        } else {
            values_[offset] = value;
        }
    }

    std::function<void(std::uint32_t)> bridges_;
    std::function<void()> warm_;
    std::map<std::uint32_t, std::uint32_t> values_{{MPUMODRST, CPU1}};
};

}  // namespace sim
