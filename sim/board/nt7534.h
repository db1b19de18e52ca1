// nt7534.h - the display controller NT7534 by its serial interface, and a panel of 128 x 64 dots
//
// A byte is a command, or eight dots below each other in the page's column, bit 0 at the top; the
// column moves on with each, up to the last.
//
//   0x  1x     column 3:0, 7:4              A4 A5   as in memory; all dots on
//   40 - 7F    first line                   A6 A7   as in memory; inverted
//   B0 - B8    page                         AE AF   display off, on
//   A0 A1      columns from the left; right C0 C8   lines from the bottom; top
//   2F         booster, regulator, follower E0 EE   keeps the column; goes back to it
//   81, AD     take a byte: contrast, static indicator
//   E2         line, page and column 0, lines from the bottom
//
// Nothing is seen until the display is on and all three power circuits are.  The panel is mounted
// as on the DE10-Standard, where Terasic's programs send C8 and leave A0: line 0 is at the top,
// column 0 at the left.
//
// Source: the table of commands in the data sheet of the NT7502 (Novatek), which has the same;
// Terasic's demonstrations for the DE10-Standard, which name the NT7534, for the rest.
//
// Not handled: reading, contrast, bias, resistors, the oscillator and the static indicator, which
// are taken and change nothing; page 8, the icons; memory that is random at power-on.
#pragma once

#include <array>
#include <cstdint>

#include "sim/board/display_picture.h"

namespace sim {

class Nt7534 {
public:
    static constexpr unsigned WIDTH = 128, HEIGHT = 64;

    void reset();  // as its pin; the memory stays
    void write(std::uint8_t byte, bool is_data);

    // Black dots on white, or on grey without the backlight.
    DisplayPicture picture(bool backlight) const;

private:
    static constexpr unsigned COLUMNS = 132, PAGES = 9;

    void command(std::uint8_t byte);
    void begin_anew();
    bool is_on(unsigned x, unsigned y) const;

    std::array<std::array<std::uint8_t, COLUMNS>, PAGES> memory_{};
    unsigned column_ = 0, kept_column_ = 0, page_ = 0, first_line_ = 0;
    std::uint8_t power_ = 0;
    bool takes_byte_ = false;  // the next one belongs to the command before
    bool on_ = false, all_ = false, inverted_ = false, from_right_ = false, from_top_ = false;
};

}  // namespace sim
