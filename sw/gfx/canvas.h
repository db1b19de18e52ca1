// canvas.h - a picture to draw on, in memory.
//
// Everything is clipped: any int is a legal coordinate, and what falls outside is not drawn.
#pragma once

#include <array>
#include <cstdint>

#include "gfx/colour.h"

namespace gfx {

class Canvas {
public:
    static constexpr int WIDTH = 320, HEIGHT = 240;

    void pixel(int x, int y, Colour colour);

    // Bresenham's line, both ends included.  Exchanging the ends gives the same pixels, and
    // clipping removes exactly the pixels of the line that lie outside.
    void line(int x0, int y0, int x1, int y1, Colour colour);

    // An outline and a filled rectangle; nothing if width or height is below 1.
    void rect(int x, int y, int width, int height, Colour colour);
    void fill(int x, int y, int width, int height, Colour colour);

    void clear();  // to black

    // WIDTH pixels; 0 <= y < HEIGHT.
    const Colour* row(int y) const { return &pixels_[index(0, y)]; }

private:
    static constexpr unsigned index(int x, int y) { return static_cast<unsigned>(y * WIDTH + x); }

    std::array<Colour, WIDTH * HEIGHT> pixels_{};
};

}  // namespace gfx
