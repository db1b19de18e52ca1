// lt24.h - Terasic's LT24: an ILI9341 on the pins of a 40-pin header
//
//   GPIO   8 7 6 5 13-24    10    11    12  25    33       35
//          D0-D3   D4-D15  RD_N  WR_N   RS  CS_N  RESET_N  LCD_ON
//
// Not handled: the touch screen's converter.
#pragma once

#include "sim/board/header_part.h"
#include "sim/board/ili9341.h"

namespace sim {

class Lt24 : public HeaderPart {
public:
    // Those of GPIO_0 or GPIO_1 that it is on.
    static HeaderPinList pins(unsigned header) {
        HeaderPinList pins;
        for (const unsigned pin :
             {8, 7, 6, 5, 13, 14, 15, 16, 17, 18, 19, 20, 21, 22, 23, 24, 10, 11, 12, 25, 33, 35})
            pins.push_back(header * PINS_OF_A_HEADER + pin);
        return pins;
    }

    explicit Lt24(unsigned header) : header_{header} {}

    void look(const HeaderMasks& levels, std::uint64_t) override {
        const std::uint64_t now = levels[header_] & PINS;
        if (now == before_) return;
        before_ = now;
        const auto pin = [now](unsigned n) { return now >> n & 1; };
        const std::uint64_t data =
            (now >> 13 & 0xfff) << 4 | pin(5) << 3 | pin(6) << 2 | pin(7) << 1 | pin(8);
        display_.drive({pin(33) != 0, pin(25) != 0, pin(12) != 0, pin(11) != 0, pin(35) != 0,
                        static_cast<std::uint16_t>(data)});
    }

    std::optional<DisplayPicture> picture() const override { return display_.picture(); }

private:
    static constexpr std::uint64_t PINS = 0xA03FFFDE0;

    const unsigned header_;
    std::uint64_t before_ = 0;
    Ili9341 display_;
};

}  // namespace sim
