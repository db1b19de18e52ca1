#include "sim/video/sound_track.h"

#include <samplerate.h>

#include <algorithm>
#include <cmath>
#include <new>
#include <utility>

namespace sim {

namespace {

constexpr int CHANNELS = 2;
constexpr std::size_t BLOCK_VALUES = CHANNELS * 512;
constexpr double GAP_S = 0.02;  // more than the jitter of the samples' times
constexpr float FULL_SCALE = 32768;

}  // namespace

SoundTrack::SoundTrack() : resampler_{src_new(SRC_SINC_FASTEST, CHANNELS, nullptr)} {
    if (!resampler_) throw std::bad_alloc{};
}

SoundTrack::~SoundTrack() { src_delete(resampler_); }

void SoundTrack::rate(double hz) {
    if (hz <= 0 || hz == rate_hz_) return;
    resample(true);
    src_reset(resampler_);
    rate_hz_ = hz;
}

void SoundTrack::play(std::int16_t left, std::int16_t right, double time_s) {
    if (played_s_ + GAP_S < time_s) fill(time_s);
    push(left, right);
}

void SoundTrack::fill(double time_s) {
    while (played_s_ < time_s) push(0, 0);
}

void SoundTrack::close(double time_s) {
    fill(time_s);
    resample(true);
}

std::vector<std::int16_t> SoundTrack::remove() { return std::exchange(made_, {}); }

void SoundTrack::push(std::int16_t left, std::int16_t right) {
    pushed_.insert(pushed_.end(), {static_cast<float>(left), static_cast<float>(right)});
    played_s_ += 1.0 / rate_hz_;
    if (pushed_.size() == BLOCK_VALUES) resample(false);
}

// `ends`: nothing follows at this rate.
void SoundTrack::resample(bool ends) {
    SRC_DATA data{};
    data.src_ratio = RATE_HZ / rate_hz_;
    data.end_of_input = ends;
    data.data_in = pushed_.data();
    data.input_frames = static_cast<long>(pushed_.size() / CHANNELS);
    std::vector<float> out(std::size_t{CHANNELS} * 4096);
    do {
        data.data_out = out.data();
        data.output_frames = static_cast<long>(out.size() / CHANNELS);
        if (src_process(resampler_, &data) != 0) throw std::bad_alloc{};
        for (long i = 0; i < CHANNELS * data.output_frames_gen; ++i)
            made_.push_back(static_cast<std::int16_t>(std::lround(
                std::clamp(out[static_cast<std::size_t>(i)], -FULL_SCALE, FULL_SCALE - 1))));
        data.data_in += CHANNELS * data.input_frames_used;
        data.input_frames -= data.input_frames_used;
    } while (data.input_frames > 0 || data.output_frames_gen == static_cast<long>(out.size()) / 2);
    pushed_.clear();
}

}  // namespace sim
