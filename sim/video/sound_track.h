// sound_track.h - the sound at 48 kHz, AAC or Opus
//
// What the codec did not play is silence, so that the track is as long as the run.
#pragma once

#include <cstdint>
#include <vector>

#include "sim/video/muxer.h"

struct AVAudioFifo;

namespace sim {

class SoundTrack {
public:
    explicit SoundTrack(Muxer& muxer);
    ~SoundTrack();

    void rate(double hz);
    void play(std::int16_t left, std::int16_t right, double time_s);
    // Silence up to there, unless there is sound already.
    void fill(double time_s);
    void close(double time_s);

private:
    void push(std::int16_t left, std::int16_t right);
    void resample();  // what has been pushed
    void drain();     // what the resampler holds
    void keep(const std::uint8_t** samples, int count);
    void write(int count);
    void encode_frame(const AVFrame* frame);

    Muxer& muxer_;
    AvEncoder encoder_;
    const AVStream* track_;
    AvResampler resampler_;
    AVAudioFifo* waiting_;  // at 48 kHz, for a whole frame
    std::vector<std::int16_t> pushed_;
    int rate_hz_ = 0;
    double played_s_ = 0;
    std::int64_t written_ = 0;  // samples
};

}  // namespace sim
