// error.h - why the library refused its input.  Any other input is handled.
#pragma once

namespace collision {

enum class [[nodiscard]] Error{
    NONE,
    NOT_FINITE,      // NaN or an infinity given to to_grid()
    OUTSIDE_GRID,    // a coordinate that is not below COORDINATE_LIMIT in size
    TOO_MANY_LINES,  // more than Polygon::MAX_LINES
    BOX_INSIDE_OUT,  // a box with min above max on an axis
};

// In words, without a full stop: "a coordinate is outside the grid".  "no error" for NONE.
const char* text(Error error);

}  // namespace collision
