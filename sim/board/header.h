// header.h - the 36 wires of GPIO_0 or GPIO_1: driven by the FPGA, by what is plugged in, and by
// pull-ups.
//
// A wire without a driver is high.
//
// Not handled: contention.  A wire that one side drives high and the other low is low here; on a
// board it may damage a pin.
#pragma once

#include <cstdint>

#include "sim/pins/header_bits.h"

namespace sim {

enum class PinLevel { LOW, HIGH, RELEASED };

class Header {
public:
    // What the FPGA drives, where `enable` is 1.
    void fpga(std::uint64_t levels, std::uint64_t enable) {
        high_ = levels & enable;
        low_ = ~levels & enable;
    }
    // From now on, on the wires of `pins`.
    void outside(std::uint64_t pins, PinLevel level) {
        outside_high_ = (outside_high_ & ~pins) | (level == PinLevel::HIGH ? pins : 0);
        outside_low_ = (outside_low_ & ~pins) | (level == PinLevel::LOW ? pins : 0);
    }

    std::uint64_t outputs() const { return high_ | low_; }  // of the FPGA
    std::uint64_t driven() const { return high_ | low_ | outside_high_ | outside_low_; }
    std::uint64_t levels() const { return ALL_HEADER_PINS & ~(low_ | outside_low_); }

private:
    std::uint64_t high_ = 0, low_ = 0, outside_high_ = 0, outside_low_ = 0;
};

}  // namespace sim
