// frame_meter.h - measures a video signal frame by frame, knowing no standard
//
// A line begins where a pulse of HS begins, a frame where one of VS does.  A VS that begins in the
// second half of a line belongs to the next line, with which the frame then begins.  The unit of
// time is the sample, whatever its period.
#pragma once

#include <cstdint>

#include "sim/board/sync_meter.h"

namespace sim {

// A frame from one VS to the next.
struct VideoSignal {
    enum class Blank { NEVER_LOW, NEVER_HIGH, MOVES };

    unsigned lines = 0;       // 0: nothing was measured yet
    double line_samples = 0;  // mean of them
    unsigned even_line = 0;   // length in samples of nearly all lines; 0: they differ
    bool hs_positive = false, vs_positive = false;
    Blank blank = Blank::NEVER_LOW;
    // With BLANK_N high: samples of a line, or of most of them if they differ, and lines.
    unsigned shown_samples = 0, shown_lines = 0;

    // The same but for a line in 100, 0.1 % of a line and 1 of what is shown: what glitches do.
    bool similar_to(const VideoSignal& other) const;
};

// Of the numbers that it is given, the one that is more than half of them, if there is one (Boyer
// and Moore's vote); else any of them.
class Majority {
public:
    void vote(unsigned value) {
        if (votes_ == 0) value_ = value;
        votes_ += value == value_ ? 1 : -1;
    }
    unsigned value() const { return value_; }
    int votes() const { return votes_; }  // at least those for value() less those against it

private:
    unsigned value_ = 0;
    int votes_ = 0;
};

class FrameMeter {
public:
    struct Begins {
        bool line, frame;  // with the first sample of the run
    };

    // The next `count` samples, in which HS, VS and BLANK_N are as in `control` (bits: sim/fpga/
    // fabric.h, video).
    Begins run(std::uint32_t control, unsigned count);

    // The last whole frame.
    const VideoSignal& signal() const { return signal_; }

    // From now on lines are about so long, and a pulse of HS before three quarters of that is a
    // glitch; 0: nothing is known.
    void expect_line(double samples) { earliest_ = samples * 0.75; }

    const SyncMeter& hs() const { return hs_; }
    const SyncMeter& vs() const { return vs_; }

private:
    void end_line(std::uint64_t samples);
    void end_frame();

    SyncMeter hs_, vs_;
    VideoSignal signal_;
    double earliest_ = 0;
    std::uint64_t since_line_ = 0;  // samples since the line began
    bool vs_waits_ = false;         // it has begun, the frame begins with the next line
    bool in_frame_ = false;         // one has begun

    // Of this frame and this line.
    std::uint64_t samples_ = 0;
    unsigned lines_ = 0, shown_lines_ = 0, shown_samples_ = 0;
    bool was_low_ = false, was_high_ = false;  // BLANK_N
    Majority length_, shown_;
};

}  // namespace sim
