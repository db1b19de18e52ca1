// sound_source.h - what is at an input of the codec: silence, a tone, or a recording.
//
// It sounds in simulated time, whether the codec listens or not.  Of a recording whose rate is the
// codec's, every sample comes as it is and each once, as long as the codec goes on listening.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>

#include "sim/board/recording.h"

namespace sim {

enum class SoundInput { LINE_IN, MICROPHONE };

class SoundSource {
public:
    // Each takes the place of what there was; `now_ps` is when it begins.
    void silence();
    void tone(double hz, double level, std::uint64_t now_ps);  // 1 is full scale
    void play(std::shared_ptr<const Recording> recording, bool for_ever, std::uint64_t now_ps);

    // For a codec that samples at this rate; silence while that is 0, not known.
    StereoSample sample(std::uint64_t now_ps, double rate_hz);

private:
    StereoSample next(std::uint64_t now_ps, double rate_hz);

    std::uint64_t began_ps_ = 0, sampled_ps_ = 0;
    double hz_ = 0, level_ = 0;
    std::shared_ptr<const Recording> recording_;
    bool for_ever_ = false;
    std::optional<Recording> played_;  // at the codec's rate, once that is known
    std::uint64_t place_ = 0;          // in it
};

}  // namespace sim
