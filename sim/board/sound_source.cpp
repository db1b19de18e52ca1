#include "sim/board/sound_source.h"

#include <cmath>
#include <utility>

namespace sim {

namespace {

constexpr double SECOND_PS = 1e12, TWO_PI = 6.283185307179586;

}  // namespace

void SoundSource::silence() { *this = {}; }

void SoundSource::tone(double hz, double level, std::uint64_t now_ps) {
    *this = {};
    began_ps_ = now_ps;
    hz_ = hz;
    level_ = level;
}

void SoundSource::play(std::shared_ptr<const Recording> recording, bool for_ever,
                       std::uint64_t now_ps) {
    *this = {};
    if (recording->samples.empty()) return;
    began_ps_ = now_ps;
    recording_ = std::move(recording);
    for_ever_ = for_ever;
}

StereoSample SoundSource::sample(std::uint64_t now_ps, double rate_hz) {
    if (rate_hz == 0 || now_ps < began_ps_) return {};
    if (recording_) return next(now_ps, rate_hz);
    if (level_ == 0) return {};
    const double time_s = static_cast<double>(now_ps - began_ps_) / SECOND_PS;
    const auto value = static_cast<std::int32_t>(
        std::lround(level_ * 0x7fffffff * std::sin(TWO_PI * hz_ * time_s)));
    return {value, value};
}

StereoSample SoundSource::next(std::uint64_t now_ps, double rate_hz) {
    const bool another_rate = !played_ || std::abs(played_->rate_hz / rate_hz - 1) > 1e-4;
    if (another_rate) played_ = at_rate(*recording_, rate_hz);
    const bool paused = static_cast<double>(now_ps - sampled_ps_) * rate_hz > 1.5 * SECOND_PS;
    sampled_ps_ = now_ps;
    if (another_rate || paused)
        place_ = static_cast<std::uint64_t>(static_cast<double>(now_ps - began_ps_) / SECOND_PS *
                                            rate_hz);
    else
        ++place_;
    const auto& samples = played_->samples;
    if (!for_ever_ && place_ >= samples.size()) return {};
    return samples[place_ % samples.size()];
}

}  // namespace sim
