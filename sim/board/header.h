// header.h - the at most 36 wires of a header: driven by the FPGA, by hand, by the parts that are
// plugged in, and by pull-ups.
//
// A wire without a driver is high.  One that is driven high and low at once is low here, and is
// among conflicts(): on a board it may damage a pin.
#pragma once

#include <cstdint>

#include "sim/pins/header_bits.h"

namespace sim {

enum class PinLevel { LOW, HIGH, RELEASED };

class Header {
public:
    // What the FPGA drives, where `enable` is 1.
    void fpga(std::uint64_t levels, std::uint64_t enable) {
        fpga_.high = levels & enable;
        fpga_.low = ~levels & enable;
    }
    // From now on, on the wires of `pins`: by a person's hand, and by a part.
    void hand(std::uint64_t pins, PinLevel level) { hand_.drive(pins, level); }
    void part(std::uint64_t pins, PinLevel level) { part_.drive(pins, level); }

    std::uint64_t outputs() const { return fpga_.high | fpga_.low; }  // of the FPGA
    std::uint64_t driven() const { return high() | low(); }
    std::uint64_t levels() const { return ALL_HEADER_PINS & ~low(); }
    std::uint64_t conflicts() const { return high() & low(); }

private:
    struct Driver {
        std::uint64_t high = 0, low = 0;

        void drive(std::uint64_t pins, PinLevel level) {
            high = (high & ~pins) | (level == PinLevel::HIGH ? pins : 0);
            low = (low & ~pins) | (level == PinLevel::LOW ? pins : 0);
        }
    };

    std::uint64_t high() const { return fpga_.high | hand_.high | part_.high; }
    std::uint64_t low() const { return fpga_.low | hand_.low | part_.low; }

    Driver fpga_, hand_, part_;
};

}  // namespace sim
