// app_sound_test.cpp - pitch, loudness and silence, measured on the samples.
#include <gtest/gtest.h>

#include <algorithm>
#include <climits>
#include <cmath>
#include <vector>

#include "app/sound.h"

namespace {

using namespace app;

constexpr unsigned SLOW = 8'000, FAST = 48'000;
constexpr int MIDDLE = 160;

std::vector<StereoSample> listen(Mixer& mixer, unsigned rate, double seconds) {
    std::vector<StereoSample> samples(static_cast<std::size_t>(seconds * rate), {99, 99});
    mixer.mix(samples.data(), static_cast<unsigned>(samples.size()), rate);
    return samples;
}

std::vector<StereoSample> tone(unsigned size_a, unsigned size_b, int x = MIDDLE,
                               unsigned rate = FAST) {
    Mixer mixer;
    mixer.note(size_a, size_b, x);
    return listen(mixer, rate, 0.2);
}

bool silent(const StereoSample& s) { return s.left == 0 && s.right == 0; }

bool equal(const StereoSample& a, const StereoSample& b) {
    return a.left == b.left && a.right == b.right;
}

std::int64_t peak(const std::vector<StereoSample>& samples) {
    std::int64_t most = 0;
    for (const StereoSample& s : samples)
        most = std::max({most, std::abs(std::int64_t{s.left}), std::abs(std::int64_t{s.right})});
    return most;
}

TEST(Pitch, FallsByAnOctaveForEightPixels) {
    for (unsigned a = MIN_SIZE; a <= MAX_SIZE; ++a)
        for (unsigned b = MIN_SIZE; b <= MAX_SIZE; ++b)
            EXPECT_EQ(pitch_hz(a, b), std::lround(440 * std::exp2((32.0 - a - b) / 8)));
    EXPECT_EQ(pitch_hz(20, 20), 220u);
    EXPECT_EQ(pitch_hz(16, 16), 440u);
    EXPECT_EQ(pitch_hz(12, 12), 880u);
}

TEST(Pitch, StaysWithinTwoOctavesForAnySize) {
    EXPECT_EQ(pitch_hz(0, 0), 880u);
    EXPECT_EQ(pitch_hz(UINT_MAX, UINT_MAX), 220u);
    EXPECT_EQ(pitch_hz(0, UINT_MAX), 440u);
}

// Where the tone crosses zero upwards, between samples, first and last: whole turns over their
// time.
double measured_hz(const std::vector<StereoSample>& samples, unsigned rate) {
    std::vector<double> crossings;
    for (std::size_t i = 1; i < samples.size(); ++i) {
        const double before = samples[i - 1].left, now = samples[i].left;
        if (before < 0 && now >= 0) crossings.push_back(i - now / (now - before));
    }
    return (crossings.size() - 1) * rate / (crossings.back() - crossings.front());
}

TEST(Mixer, PlaysThePitchAtBothSampleRates) {
    for (const unsigned rate : {SLOW, FAST})
        for (const unsigned size : {12u, 14u, 16u, 20u})
            EXPECT_NEAR(measured_hz(tone(size, size, MIDDLE, rate), rate) / pitch_hz(size, size), 1,
                        0.01);
}

TEST(Mixer, IsExactlySilentBeforeAndAfterATone) {
    for (const unsigned rate : {SLOW, FAST}) {
        Mixer mixer;
        for (const StereoSample& s : listen(mixer, rate, 0.05)) ASSERT_TRUE(silent(s));
        mixer.note(16, 16, MIDDLE);
        const auto sounding = listen(mixer, rate, 0.11);
        const auto last = std::find_if_not(sounding.rbegin(), sounding.rend(), silent);
        EXPECT_NEAR(double(sounding.rend() - last) / rate, 0.1, 0.002);
        for (const StereoSample& s : listen(mixer, rate, 0.2)) ASSERT_TRUE(silent(s));
    }
}

TEST(Mixer, LetsATonePassAway) {
    const auto samples = tone(16, 16);
    const auto part = [&samples](double from_s, double to_s) {
        return peak({samples.begin() + static_cast<long>(from_s * FAST),
                     samples.begin() + static_cast<long>(to_s * FAST)});
    };
    EXPECT_GT(part(0, 0.01), INT_MAX / 16) << "loud enough to hear";
    EXPECT_NEAR(double(part(0.049, 0.052)) / part(0, 0.003), 0.25 / 0.98, 0.03);
    EXPECT_LT(part(0.095, 0.1), part(0, 0.01) / 200);
}

TEST(Mixer, NeverClipsWithAllVoicesInStep) {
    for (const unsigned size : {12u, 16u, 20u}) {
        for (const int x : {INT_MIN, 0, MIDDLE, 319, INT_MAX}) {
            Mixer mixer;
            for (unsigned i = 0; i < Mixer::VOICES; ++i) mixer.note(size, size, x);
            const auto all = listen(mixer, FAST, 0.2), one = tone(size, size, x);
            for (std::size_t i = 0; i < all.size(); ++i) {
                ASSERT_EQ(all[i].left, std::int64_t{one[i].left} * Mixer::VOICES);
                ASSERT_EQ(all[i].right, std::int64_t{one[i].right} * Mixer::VOICES);
            }
            EXPECT_GT(peak(all), INT_MAX / 2);
            EXPECT_LT(peak(all), INT_MAX);
        }
    }
}

TEST(Mixer, GivesTheNinthToneThePlaceOfTheOldest) {
    Mixer nine, eight;
    nine.note(20, 20, MIDDLE);
    for (unsigned i = 0; i < Mixer::VOICES; ++i) {
        nine.note(12 + i, 12, MIDDLE);
        eight.note(12 + i, 12, MIDDLE);
    }
    const auto a = listen(nine, FAST, 0.2), b = listen(eight, FAST, 0.2);
    EXPECT_TRUE(std::equal(a.begin(), a.end(), b.begin(), equal));
}

TEST(Mixer, GivesTheSameSamplesInPiecesOfAnySize) {
    const auto whole = tone(13, 18, 40);
    Mixer mixer;
    mixer.note(13, 18, 40);
    std::vector<StereoSample> pieces(whole.size());
    unsigned done = 0;
    for (unsigned size = 0; done < pieces.size(); ++size) {
        const unsigned count = std::min(size, static_cast<unsigned>(pieces.size()) - done);
        mixer.mix(&pieces[done], count, FAST);
        done += count;
    }
    EXPECT_TRUE(std::equal(whole.begin(), whole.end(), pieces.begin(), equal));
}

TEST(Mixer, IsLouderOnTheSideOfTheCollision) {
    const auto left = tone(16, 16, 0), middle = tone(16, 16, MIDDLE), right = tone(16, 16, 319);
    const std::size_t crest = static_cast<std::size_t>(FAST / 440 / 4);
    EXPECT_NEAR(double(left[crest].left) / left[crest].right, 2, 0.01);
    EXPECT_NEAR(double(middle[crest].left) / middle[crest].right, 1, 0.01);
    EXPECT_NEAR(double(right[crest].left) / right[crest].right, 0.5, 0.01);
}

// ---- Collisions ----

class SoundCollisions : public testing::Test {
protected:
    World world{1};

    SoundCollisions() {
        step(world, {"B123"});
        for (unsigned i = 0; i < 3; ++i) {
            world.bodies[i].size = 12 + 4 * i;
            world.bodies[i].position = {160 * collision::PIXEL, 100 * collision::PIXEL};
        }
        world.pairs = world.pairs_before = {};
    }

    std::vector<StereoSample> heard() const {
        Mixer mixer;
        sound_collisions(world, mixer);
        return listen(mixer, FAST, 0.2);
    }
};

TEST_F(SoundCollisions, PlaysANewPairAndNotOneThatLasts) {
    world.pairs = {{EDGES, EDGES + 2}};
    const auto first = heard(), expected = tone(12, 20, 160);
    EXPECT_TRUE(std::equal(first.begin(), first.end(), expected.begin(), equal));
    world.pairs_before = world.pairs;
    EXPECT_EQ(peak(heard()), 0);
    world.pairs = {};
    EXPECT_EQ(peak(heard()), 0) << "parting makes no sound";
}

TEST_F(SoundCollisions, PlaysAnEdgeAsAShapeOfItsKind) {
    world.pairs = {{BOTTOM, EDGES + 2}};
    const auto samples = heard(), expected = tone(20, 20, 160);
    EXPECT_TRUE(std::equal(samples.begin(), samples.end(), expected.begin(), equal));
}

TEST_F(SoundCollisions, IsSilentWithoutAny) { EXPECT_EQ(peak(heard()), 0); }

}  // namespace
