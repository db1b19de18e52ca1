// hps_lcd.h - the DE10-Standard's LCD on pins of the HPS: SPI master 0, and three of GPIO1
//
//   GPIO37 (bit 8) backlight, 1 = on    GPIO41 (bit 12) D/C, 1 = data    GPIO44 (bit 15) reset, 0
//
// Source: Terasic's demonstration hps_lcd for the DE10-Standard.
//
// Not handled: frames of other sizes than 8 bits, of which the lowest 8 bits are taken.
#pragma once

#include <cstdint>
#include <optional>

#include "sim/board/nt7534.h"
#include "sim/board/part.h"

namespace sim {

class HpsLcd : public Part {
public:
    // The levels of GPIO1's pins; a frame that SPI master 0 has sent while slave 0 was selected.
    void gpio1(std::uint32_t levels) {
        levels_ = levels;
        if (is_reset()) controller_.reset();
    }
    void spi0(std::uint32_t frame) {
        if (!is_reset()) controller_.write(static_cast<std::uint8_t>(frame), levels_ >> DATA & 1);
    }

    std::optional<DisplayPicture> picture() const override {
        return controller_.picture(levels_ >> BACKLIGHT & 1);
    }

private:
    static constexpr unsigned BACKLIGHT = 8, DATA = 12, RESET_N = 15;

    bool is_reset() const { return !(levels_ >> RESET_N & 1); }

    std::uint32_t levels_ = ~std::uint32_t{0};
    Nt7534 controller_;
};

}  // namespace sim
