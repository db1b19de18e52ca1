// recording.h - a sound file in memory, to be played into the board.
#pragma once

#include <filesystem>
#include <vector>

#include "sim/board/digital_audio.h"

namespace sim {

struct Recording {
    double rate_hz = 0;
    std::vector<StereoSample> samples;  // a mono file is on both channels
};

// Any file that libsndfile reads, WAV among them; 16 and 24 bits come through exactly.
// std::runtime_error, the path and what is wrong: no such file, no sound, more than two channels,
// longer than five minutes.
Recording read_recording(const std::filesystem::path& path);

// The same sound at another rate.  The samples are unchanged if the rates differ by less than a
// crystal's tolerance, 0.01 %.
Recording at_rate(const Recording& recording, double rate_hz);

}  // namespace sim
