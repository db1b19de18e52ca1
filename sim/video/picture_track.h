// picture_track.h - the pictures at twice their size, H.264 or VP9
//
// Browsers want colour at half the resolution (4:2:0).  At twice the size that is one colour per
// pixel of the monitor, so nothing is lost by it.
#pragma once

#include <cstdint>
#include <deque>
#include <vector>

#include "sim/video/muxer.h"

namespace sim {

class PictureTrack {
public:
    PictureTrack(Muxer& muxer, unsigned width, unsigned height);

    // Shown from `time_s` on.  Another size is scaled.
    void show(const std::vector<std::uint32_t>& pixels, unsigned width, unsigned height,
              double time_s);
    void close(double time_s);

private:
    void draw(const std::vector<std::uint32_t>& pixels, unsigned width, unsigned height);
    // The picture that was waiting for its end.
    void end_picture(double time_s);
    void write(const AVFrame* frame);

    Muxer& muxer_;
    unsigned width_, height_;  // the monitor's
    AvEncoder encoder_;
    const AVStream* track_;
    AvFrame picture_;
    bool waiting_ = false;
    std::deque<std::int64_t> durations_;  // of the pictures in the encoder, in order
};

}  // namespace sim
