// present.h - brings a canvas into the display's back picture, sending only what may have changed.
#pragma once

#include <array>

#include "gfx/canvas.h"
#include "hal/display.h"

namespace app {

// Of each row it sends the columns drawn now together with those drawn when this picture was the
// back one before: everything else is black on both.  At most 153,600 bytes, in bursts of a row.
class Presenter {
public:
    void present(const gfx::Canvas& canvas, hal::Display& display);

private:
    // What lies on the two pictures; both are black at power-on.
    std::array<std::array<gfx::Canvas::Span, gfx::Canvas::HEIGHT>, 2> shown_{};
};

}  // namespace app
