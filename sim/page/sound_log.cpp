// sound_log.cpp - see sound_log.h
#include "sim/page/sound_log.h"

#include <algorithm>
#include <cmath>

#include "sim/board/tone.h"

namespace sim::page {

namespace {

constexpr double STRETCH_S = 0.05;
constexpr double MIN_LEVEL_DBFS = -60, MIN_SHARE = 0.5, ALIKE = 0.02;

SoundLog::Span span_of(SoundLog::Span a, SoundLog::Span b) {
    return {std::min(a.low, b.low), std::max(a.high, b.high)};
}

}  // namespace

void SoundLog::sample_rate(double hz) {
    listen();
    rate_hz_ = hz;
}

void SoundLog::sample(double time_s, std::int16_t left, std::int16_t right) {
    while (time_s >= span_s_ * MOST) {  // two become one
        for (std::size_t i = 0; i < envelope_.size(); i += 2)
            envelope_[i / 2] =
                i + 1 < envelope_.size() ? span_of(envelope_[i], envelope_[i + 1]) : envelope_[i];
        envelope_.resize((envelope_.size() + 1) / 2);
        span_s_ *= 2;
    }
    const auto at = static_cast<std::size_t>(time_s / span_s_);
    if (at >= envelope_.size()) envelope_.resize(at + 1);
    envelope_[at] = span_of(envelope_[at], {std::min(left, right), std::max(left, right)});

    if (left_.empty()) from_s_ = time_s;
    to_s_ = time_s;
    left_.push_back(left);
    right_.push_back(right);
    if (static_cast<double>(left_.size()) >= STRETCH_S * rate_hz_) listen();
}

void SoundLog::listen() {
    const auto loudness = [](const std::vector<std::int16_t>& samples) {
        double sum = 0;
        for (const std::int16_t sample : samples) sum += std::abs(sample);
        return sum;
    };
    const double left = loudness(left_), right = loudness(right_);
    if (rate_hz_ > 0 && left + right > 0 && tones_.size() < MOST_TONES) {
        const sim::Tone tone = analyse_tone(left >= right ? left_ : right_, rate_hz_);
        if (tone.hz > 0 && tone.share >= MIN_SHARE && tone.level_dbfs >= MIN_LEVEL_DBFS) {
            Tone* last = tones_.empty() ? nullptr : &tones_.back();
            if (last && from_s_ - last->to_s < STRETCH_S / 2 &&
                std::abs(tone.hz - last->hz) <= ALIKE * last->hz) {
                last->to_s = to_s_;
                last->level_dbfs = std::max(last->level_dbfs, tone.level_dbfs);
            } else {
                tones_.push_back({from_s_, to_s_, tone.hz, tone.level_dbfs});
            }
        }
    }
    left_.clear();
    right_.clear();
}

}  // namespace sim::page
