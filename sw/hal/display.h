// display.h - driver for the PIXEL block: two pictures, one on screen, one to draw into.
//
//   write_row ... write_row, swap, [frame ends], swapped -> the other picture is the back one
#pragma once

#include <cstdint>

#include "hal/mmio.h"
#include "regmap.h"

namespace hal {

class Display {
public:
    static constexpr unsigned WIDTH = 320, HEIGHT = 240;

    // The picture in the on-chip memory is on screen, as after reset; the one in the SDRAM is the
    // back picture.
    explicit Display(Mmio& io) : io_{io} {
        io_.write(regmap::PIXEL_BACK_BUFFER, regmap::SDRAM_BASE);
    }

    // Words `first` to `first + count - 1` of a row of the back picture, two pixels per word with
    // the left one in the low half; first + count <= WIDTH / 2.
    void write_row(unsigned row, unsigned first, const std::uint32_t* words, unsigned count) {
        io_.write_words(back_ + (row << 10) + (first << 2), words, count);
    }

    // Asks for the back picture to be shown when this frame ends.  Do not draw until swapped().
    void swap() { io_.write(regmap::PIXEL_BUFFER, 1); }

    // True once after the swap that was asked for has taken place.
    bool swapped() {
        if (io_.read(regmap::PIXEL_STATUS) & regmap::PIXEL_STATUS_S_MASK) return false;
        back_ = back_ == regmap::SDRAM_BASE ? regmap::ONCHIP_BASE : regmap::SDRAM_BASE;
        return true;
    }

    // Which of the two pictures is the back one: 0 or 1.
    unsigned back() const { return back_ == regmap::SDRAM_BASE; }

private:
    Mmio& io_;
    std::uint32_t back_ = regmap::SDRAM_BASE;
};

}  // namespace hal
