// sound_log.h - the sound of a run as a plot has it: its envelope, and the tones in it
#pragma once

#include <cstdint>
#include <vector>

namespace sim::page {

class SoundLog {
public:
    static constexpr std::size_t MOST = 1200, MOST_TONES = 500;

    struct Span {  // the least and the largest sample of both channels
        std::int16_t low = 0, high = 0;
    };
    struct Tone {
        double from_s, to_s, hz, level_dbfs;
    };

    void sample(double time_s, std::int16_t left, std::int16_t right);
    void sample_rate(double hz);

    // From power-on, each `span_s()` long.
    const std::vector<Span>& envelope() const { return envelope_; }
    double span_s() const { return span_s_; }
    // Stretches of 50 ms with most of their energy at one frequency; alike ones in a row are one.
    const std::vector<Tone>& tones() const { return tones_; }

private:
    void listen();

    std::vector<Span> envelope_;
    double span_s_ = 0.005;
    double rate_hz_ = 0;
    double from_s_ = 0, to_s_ = 0;            // of the stretch
    std::vector<std::int16_t> left_, right_;  // its samples
    std::vector<Tone> tones_;
};

}  // namespace sim::page
