// panel.h - driver for the board's lamps and switches: LEDR, HEX5-0, SW.
#pragma once

#include <cstdint>

#include "hal/mmio.h"
#include "regmap.h"

namespace hal {

class Panel {
public:
    explicit Panel(Mmio& io) : io_{io} {}

    std::uint32_t switches() const { return io_.read(regmap::SW_DATA); }

    void leds(std::uint32_t on) { io_.write(regmap::LEDR_DATA, on); }

    // Decimal on HEX3-0, without leading zeros; 9999 at the most.
    void number(unsigned value) {
        if (value > 9999) value = 9999;
        std::uint32_t segments = 0;
        for (unsigned digit = 0; digit < 4; ++digit, value /= 10) {
            if (digit > 0 && value == 0) break;
            segments |= static_cast<std::uint32_t>(DIGITS[value % 10]) << (8 * digit);
        }
        io_.write(regmap::HEX3_0_DATA, segments);
    }

private:
    static constexpr std::uint8_t DIGITS[10] = {0x3f, 0x06, 0x5b, 0x4f, 0x66,  // segments g..a
                                                0x6d, 0x7d, 0x07, 0x7f, 0x6f};

    Mmio& io_;
};

}  // namespace hal
