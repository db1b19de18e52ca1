// sound_track.h - the sound at 48 kHz, whatever the codec's rate is and however that changes
//
// What the codec did not play is silence, so that the track is as long as the run.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

struct SRC_STATE_tag;

namespace sim {

class SoundTrack {
public:
    static constexpr unsigned RATE_HZ = 48'000;

    SoundTrack();
    ~SoundTrack();
    SoundTrack(const SoundTrack&) = delete;
    SoundTrack& operator=(const SoundTrack&) = delete;

    void rate(double hz);  // of the samples to come
    void play(std::int16_t left, std::int16_t right, double time_s);
    // Silence up to there, unless there is sound already.
    void fill(double time_s);
    void close(double time_s);

    // What there is at 48 kHz since the last call, left and right in turn.
    std::vector<std::int16_t> remove();

private:
    void push(std::int16_t left, std::int16_t right);
    void resample(bool ends);

    SRC_STATE_tag* const resampler_;
    std::vector<float> pushed_;
    std::vector<std::int16_t> made_;
    double rate_hz_ = RATE_HZ, played_s_ = 0;
};

}  // namespace sim
