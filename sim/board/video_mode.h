// video_mode.h - the standard video modes that a monitor knows, and which of them a signal is meant
// to be
//
// Source: VESA and Industry Standards and Guidelines for Computer Display Monitor Timing (DMT),
// version 1.0, revision 13, where borders are counted as porches; the modes of 449 lines are IBM's
// VGA, those of the text screen.
//
//   sync begins   picture begins
//   |  sync   |  back porch  |  shown  |  front porch  |
#pragma once

#include <cstdint>

namespace sim {

struct VideoMode {
    struct Axis {  // in clocks or lines
        unsigned shown, front_porch, sync, back_porch;
        bool positive;  // polarity of the sync

        unsigned total() const { return shown + front_porch + sync + back_porch; }
        unsigned sync_to_picture() const { return sync + back_porch; }
    };
    unsigned clock_khz;
    Axis h, v;

    double line_ps() const { return h.total() * 1e9 / clock_khz; }
    double frame_hz() const { return 1e3 * clock_khz / h.total() / v.total(); }
};

// What is known of a signal.
struct VideoTiming {
    double line_ps;
    double line_samples;  // of whatever clock
    unsigned lines;       // of a frame
    bool hs_positive, vs_positive;
    unsigned shown_lines;  // 0: not known
};

// The mode that is nearest in the number of lines (at most 5 % off) and a line's duration (10 %);
// among those that are alike in both - the three of 449 lines - the one with these polarities, so
// many picture lines, and a line that is a whole multiple of its clocks.  nullptr: none is near.
const VideoMode* nearest_mode(const VideoTiming& timing);

}  // namespace sim
