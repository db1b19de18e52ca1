// font.h - the project's own letters, 5 x 7 pixels and a row for descenders.
#pragma once

#include <string_view>

#include "gfx/canvas.h"

namespace gfx {

constexpr int CELL_WIDTH = 6, CELL_HEIGHT = 9;  // with the gap to the next letter and line

constexpr int text_width(std::string_view text) {
    return static_cast<int>(text.size()) * CELL_WIDTH;
}

// Draws the strokes only; (x, y) is the top left of the first cell.  Printable ASCII; anything else
// appears as '?'.
void text(Canvas& canvas, int x, int y, std::string_view text, Colour colour);

}  // namespace gfx
