// ili9341.h - the display controller ILI9341 on a 16-bit bus of the 8080 kind, and its panel
//
// A word is taken at the rise of WR_N while CS_N is low: a command while RS is low, else a
// parameter or a part of a pixel.  The panel is mounted as on the LT24: with SS of command B6 it is
// not mirrored without MX, else with it; its colours are right with BGR.
//
// Handled: SWRESET, SLPIN, SLPOUT, INVON, INVOFF, DISPON, DISPOFF, CASET, PASET, RAMWR, RAMWRC,
// MADCTL (MY, MX, MV, BGR), COLMOD (16 bits: 565 in a word; 18 bits: two pixels in three words),
// and SS and GS of the display function control (B6).
//
// Not handled: reading; other commands, such as gamma, scrolling, partial and idle mode, which are
// taken and ignored; the times that a reset and SLPOUT take; memory that is random at power-on.
#pragma once

#include <cstdint>
#include <vector>

#include "sim/board/display_picture.h"

namespace sim {

class Ili9341 {
public:
    static constexpr unsigned WIDTH = 240, HEIGHT = 320;

    struct Pins {
        bool reset_n, cs_n, rs, wr_n, backlight;
        std::uint16_t data;
    };

    void drive(const Pins& pins);

    // What is seen by a person who holds it so that the first page is at the top; black while it
    // sleeps, is off, or has no backlight.
    DisplayPicture picture() const;

private:
    void reset();
    void command(std::uint8_t command);
    void parameter(std::uint16_t word);
    void window(unsigned& begin, unsigned& end, std::uint8_t byte);
    void pixel_word(std::uint16_t word);
    void store(unsigned red, unsigned green, unsigned blue);  // 6 bits each
    std::uint32_t seen(unsigned x, unsigned y) const;         // of the panel

    Pins before_{true, true, true, true, false, 0};
    std::vector<std::uint32_t> memory_ = std::vector<std::uint32_t>(WIDTH * HEIGHT);
    std::uint8_t command_ = 0, madctl_ = 0, colmod_ = 0x66, function_ = 0x82;
    unsigned parameters_ = 0;  // of this command, so far
    unsigned column_begin_ = 0, column_end_ = WIDTH - 1, page_begin_ = 0, page_end_ = HEIGHT - 1;
    unsigned column_ = 0, page_ = 0;
    std::uint16_t words_[2] = {};  // of two pixels with 18 bits
    unsigned word_count_ = 0;
    bool awake_ = false, on_ = false, inverted_ = false;
};

}  // namespace sim
