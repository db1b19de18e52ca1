// sound_source.h - what is at an input of the codec: silence, a tone, or a recording.
//
// It plays in simulated time, whether the codec samples it or not.  If a recording has the codec's
// rate, each of its samples is delivered once and unchanged, as long as the codec keeps sampling.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>

#include "sim/board/part.h"
#include "sim/board/recording.h"

namespace sim {

class SoundSource : public Part {
public:
    // Each replaces what was playing; `now_ps` is when it begins.
    void silence();
    void tone(double hz, double level, std::uint64_t now_ps);  // 1 is full scale
    void play(std::shared_ptr<const Recording> recording, bool for_ever, std::uint64_t now_ps);

    // For a codec that samples at this rate; silence while the rate is unknown (0).
    StereoSample sample(std::uint64_t now_ps, double rate_hz);

private:
    StereoSample next(std::uint64_t now_ps, double rate_hz);

    std::uint64_t began_ps_ = 0, sampled_ps_ = 0;
    double hz_ = 0, level_ = 0;
    std::shared_ptr<const Recording> recording_;
    bool for_ever_ = false;
    std::optional<Recording> played_;  // at the codec's rate, once that is known
    std::uint64_t place_ = 0;          // index in it
};

}  // namespace sim
