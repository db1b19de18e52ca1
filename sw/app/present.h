// present.h - brings a canvas into the display's back picture, sending only what differs.
#pragma once

#include <array>
#include <cstdint>

#include "gfx/canvas.h"
#include "hal/display.h"

namespace app {

// Remembers both pictures, 307,200 bytes.  A call compares 38,400 words and sends those that differ
// from the back picture, row by row, in bursts.  A gap of fewer than JOIN equal words is sent too,
// which costs less than a new burst.
class Presenter {
public:
    void present(const gfx::Canvas& canvas, hal::Display& display);

private:
    static constexpr unsigned WORDS = gfx::Canvas::WIDTH / 2;  // per row; two pixels per word
    static constexpr unsigned JOIN = 8;

    using Row = std::array<std::uint32_t, WORDS>;

    static void send_difference(unsigned y, const gfx::Colour* now, Row& shown,
                                hal::Display& display);

    std::array<std::array<Row, gfx::Canvas::HEIGHT>, 2> shown_{};  // both black at power-on
};

}  // namespace app
