// sound_test.cpp - a collision is heard when it happens, at its pitch, and at no other time.
#include <algorithm>
#include <cmath>

#include "app/sound.h"
#include "sim/board/tone.h"
#include "tb/system/running_program.h"

namespace {

// Switches and keys that lead to one collision and then to none for a while.
struct Case {
    const char* name;
    std::uint16_t switches;
    const char* keys;
    bool with_edge;
};

void PrintTo(const Case& c, std::ostream* out) { *out << c.name; }

class SoundOfACollision : public tb::RunningProgram, public ::testing::WithParamInterface<Case> {
protected:
    std::vector<std::size_t> played;  // samples played by the end of each picture
    std::vector<std::size_t> notes;   // picture of each new collision, as an index of `played`
    unsigned pitch_hz = 0;
    bool with_edge = false;

    std::size_t samples(double ms) const {
        return static_cast<std::size_t>(std::lround(rate_hz * ms / 1000));
    }
    bool silent(std::size_t from, std::size_t to) const {
        const auto zeros = [&](const std::vector<std::int16_t>& channel) {
            return std::all_of(channel.begin() + static_cast<std::ptrdiff_t>(from),
                               channel.begin() + static_cast<std::ptrdiff_t>(to),
                               [](std::int16_t sample) { return sample == 0; });
        };
        return zeros(left) && zeros(right);
    }
    bool tone(const std::vector<std::int16_t>& channel, std::size_t from, std::size_t to) const {
        const std::vector<std::int16_t> stretch(channel.begin() + static_cast<std::ptrdiff_t>(from),
                                                channel.begin() + static_cast<std::ptrdiff_t>(to));
        return sim::is_tone(stretch, rate_hz, pitch_hz, 0.03);
    }

private:
    void after_picture() override {
        played.push_back(left.size());
        const app::World& world = replay->world();
        for (const auto& pair : world.pairs) {
            const auto& before = world.pairs_before;
            if (std::binary_search(before.begin(), before.end(), pair)) continue;
            const auto size = [&](unsigned i) { return world.bodies[i - app::EDGES].size; };
            with_edge = pair.first < app::EDGES;
            pitch_hz = app::pitch_hz(size(with_edge ? pair.second : pair.first), size(pair.second));
            notes.push_back(played.size() - 1);
        }
    }
};

TEST_P(SoundOfACollision, BeginsWithItAtItsPitchAndEndsInSilence) {
    ASSERT_NO_FATAL_FAILURE(start(GetParam().switches));
    ASSERT_NO_FATAL_FAILURE(press(GetParam().keys));
    for (unsigned ticks = 0; notes.empty(); ++ticks) {
        ASSERT_LT(ticks, 60u) << "no collision";
        ASSERT_NO_FATAL_FAILURE(follow(1));
    }
    ASSERT_NO_FATAL_FAILURE(follow(12));
    ASSERT_EQ(notes.size(), 1u);
    ASSERT_EQ(with_edge, GetParam().with_edge);

    // The tick was computed while the previous picture was on the screen, that is, after the end of
    // the one before that.
    const std::size_t picture = notes[0];
    EXPECT_TRUE(silent(0, played[picture - 2]));

    std::size_t begin = played[picture - 2];
    while (begin < left.size() && silent(begin, begin + 1)) ++begin;
    ASSERT_LE(begin, played[picture] + samples(40));
    EXPECT_TRUE(tone(left, begin, begin + samples(60)));
    EXPECT_TRUE(tone(right, begin, begin + samples(60)));

    const std::size_t end = begin + samples(app::Mixer::TONE_MS + 5);
    ASSERT_GE(left.size(), end + samples(40));
    EXPECT_TRUE(silent(end, left.size()));
}

INSTANTIATE_TEST_SUITE_P(Of, SoundOfACollision,
                         ::testing::Values(Case{"ASquareAndAnEdge", 41, "1", true},
                                           Case{"ASquareAndAnX", 401, "12", false}),
                         [](const auto& each) { return each.param.name; });

}  // namespace
