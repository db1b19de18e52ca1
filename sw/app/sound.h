// sound.h - a short tone for every new collision, mixed from up to eight voices.
//
// A tone is a sine that fades to silence in TONE_MS, at first twice as fast as on average.  Each
// voice has at most an eighth of full scale, so no sum can clip.  If all voices are in use, a new
// tone replaces the oldest.
#pragma once

#include <array>
#include <cstdint>

#include "app/sine.h"
#include "app/world.h"

namespace app {

struct StereoSample {
    std::int32_t left, right;  // full scale is all 32 bits
};

// The pitch when shapes of these sizes (pixels) meet: 440 Hz * 2 ^ ((32 - size_a - size_b) / 8),
// so 220 Hz for two of the largest and 880 Hz for two of the smallest; other sizes count as those.
unsigned pitch_hz(unsigned size_a, unsigned size_b);

class Mixer {
public:
    static constexpr unsigned VOICES = 8;
    static constexpr unsigned TONE_MS = 100;

    // x is the position on the screen, in pixels: left to right is 2 : 1 at the left edge, 1 : 2 at
    // the right.
    void note(unsigned size_a, unsigned size_b, int x);

    // Writes the next `count` samples at `rate_hz`; exactly 0 while no tone sounds.
    void mix(StereoSample* out, unsigned count, unsigned rate_hz);

private:
    struct Voice {
        unsigned pitch_hz = 0;  // 0: silent
        Angle phase = 0;
        std::uint32_t age = 0;             // 2^32 is TONE_MS
        std::int32_t left = 0, right = 0;  // loudness, at most LOUDEST
    };

    void add(Voice& voice, StereoSample* out, unsigned count, unsigned rate_hz);

    std::array<Voice, VOICES> voices_{};
    unsigned next_ = 0;  // all tones last equally long: the voice after the newest is the oldest
};

// A note for every pair that collides in this tick and did not in the one before.
void sound_collisions(const World& world, Mixer& mixer);

}  // namespace app
