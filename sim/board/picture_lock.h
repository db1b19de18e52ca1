// picture_lock.h - what a monitor makes of a signal that it has measured: mode, place, one sentence
//
// Where BLANK_N goes high for about the mode's picture (a sixteenth more or less), the picture is
// what it says.  Where it does not, the picture begins at the standard's distance from the begin of
// HS and VS, and has the standard's size.  BLANK_N low is black in both cases, since the ADV7123
// makes it so; but a BLANK_N that is never high is not obeyed, or nothing would be seen.
//
// Where no standard mode is near, or VGA_CLK's rate has no relation to the nearest one's, the
// picture is where BLANK_N is high, and each sample is a pixel; the lines may then have 20 to 150
// kHz, the frames 24 to 160 Hz.
//
// The samples of a pixel: one or a whole number, if all lines are equal and that comes within 3 %
// of the mode's clocks in a line; else the mode's clocks in a line are taken for true.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "sim/board/frame_meter.h"
#include "sim/board/video_mode.h"

namespace sim {

// Where the picture is in the samples.
struct Placement {
    unsigned width = 0, height = 0;  // pixels
    double samples_per_pixel = 1;
    double line_samples = 0;  // from HS to HS, mean; only of use where the former is not 1
    bool by_blank = true;     // it is where BLANK_N is high; else:
    double left = 0;          // samples from the begin of HS
    unsigned top = 0;         // lines from the begin of VS, whose own is 0
    bool blank_is_black = true;
};

struct PictureLock {
    std::optional<Placement> picture;  // none: out of range
    // "640 x 480 at 59.5 Hz, HS and VS negative, 800 x 525 clocks, BLANK_N ignored: never low"
    // "out of range: 15.7 kHz, 60.1 Hz, HS and VS negative, 262 lines"
    std::string text;
};

// `has_blank`: the board has BLANK_N; without it, it is high, and nothing is said of it.
PictureLock lock_on(const VideoSignal& signal, std::uint64_t sample_ps, bool has_blank = true);

}  // namespace sim
