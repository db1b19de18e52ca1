// sound.cpp - see sound.h
#include "app/sound.h"

#include <algorithm>
#include <iterator>

#include "gfx/canvas.h"

namespace app {
namespace {

// Hz for size_a + size_b from 24 to 40: an octave is 8 pixels.
constexpr unsigned PITCHES_HZ[] = {880, 807, 740, 679, 622, 571, 523, 480, 440,
                                   403, 370, 339, 311, 285, 262, 240, 220};
static_assert(std::size(PITCHES_HZ) == 2 * (MAX_SIZE - MIN_SIZE) + 1, "a pitch for every sum");

constexpr std::int32_t LOUDEST = 256;

// The product of sine and envelope (16 bits each) is cut to 16 bits; times the loudness (8 bits) it
// has 24.  Times GAIN it stays below 2^28, an eighth of full scale.
constexpr std::int32_t GAIN = 15;

}  // namespace

unsigned pitch_hz(unsigned size_a, unsigned size_b) {
    const auto within = [](unsigned size) { return std::clamp(size, MIN_SIZE, MAX_SIZE); };
    return PITCHES_HZ[within(size_a) + within(size_b) - 2 * MIN_SIZE];
}

void Mixer::note(unsigned size_a, unsigned size_b, int x) {
    const std::int32_t to_right = std::clamp(x, 0, gfx::Canvas::WIDTH - 1);
    const std::int32_t less = LOUDEST / 2 * to_right / (gfx::Canvas::WIDTH - 1);
    Voice& voice = voices_[next_];
    voice = {};
    voice.pitch_hz = pitch_hz(size_a, size_b);
    voice.left = LOUDEST - less;
    voice.right = LOUDEST / 2 + less;
    next_ = (next_ + 1) % VOICES;
}

void Mixer::mix(StereoSample* out, unsigned count, unsigned rate_hz) {
    std::fill(out, out + count, StereoSample{0, 0});
    for (Voice& voice : voices_) add(voice, out, count, rate_hz);
}

void Mixer::add(Voice& voice, StereoSample* out, unsigned count, unsigned rate_hz) {
    // The phase counts 2^32 per turn, the age 2^32 per tone; both steps are per sample.
    const std::uint64_t turn = std::uint64_t{1} << 32;
    const auto phase_step = static_cast<Angle>(turn * voice.pitch_hz / rate_hz);
    const std::uint64_t age_step = turn * 1000 / TONE_MS / rate_hz;

    for (unsigned i = 0; i < count && voice.pitch_hz; ++i) {
        const std::int64_t left_of_tone = SINE_ONE - static_cast<std::int32_t>(voice.age >> 16);
        const std::int64_t envelope = left_of_tone * left_of_tone / SINE_ONE;
        const auto level = static_cast<std::int32_t>(sine(voice.phase) * envelope / SINE_ONE);
        out[i].left += level * voice.left * GAIN;
        out[i].right += level * voice.right * GAIN;
        voice.phase += phase_step;
        const std::uint64_t age = voice.age + age_step;
        if (age >> 32) voice.pitch_hz = 0;
        voice.age = static_cast<std::uint32_t>(age);
    }
}

void sound_collisions(const World& world, Mixer& mixer) {
    for (const collision::CollisionPair pair : world.pairs) {
        const collision::PairList& before = world.pairs_before;
        if (std::binary_search(before.begin(), before.end(), pair)) continue;
        const Body& b = world.bodies[pair.second - EDGES];
        const Body& a = pair.first < EDGES ? b : world.bodies[pair.first - EDGES];
        const std::int32_t middle = a.position.x / 2 + b.position.x / 2;
        mixer.note(a.size, b.size, middle / collision::PIXEL);
    }
}

}  // namespace app
