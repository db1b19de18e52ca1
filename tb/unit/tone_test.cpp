// tone_test.cpp - tone detection: sines of known frequency and level, alone and with other sounds
#include "sim/board/tone.h"

#include <gmock/gmock.h>

#include <cmath>
#include <functional>
#include <random>

namespace {

using namespace sim;

constexpr double RATE_HZ = 8000;

std::vector<std::int16_t> sound(double seconds, const std::function<double(double)>& wave,
                                double rate_hz = RATE_HZ) {
    std::vector<std::int16_t> out;
    for (int i = 0; i < seconds * rate_hz; ++i)
        out.push_back(static_cast<std::int16_t>(std::lround(wave(i / rate_hz))));
    return out;
}

std::function<double(double)> sine(double hz, double amplitude = 10000, double phase = 0) {
    return [=](double t) { return amplitude * std::sin(2 * std::acos(-1.0) * hz * t + phase); };
}

TEST(Tone, IsFoundToHalfAPercentIn100Milliseconds) {
    for (double hz = 100; hz < 3500; hz *= 1.013)
        for (const double phase : {0.0, 0.7, 1.57, 3.0})
            ASSERT_NEAR(analyse_tone(sound(0.1, sine(hz, 10000, phase)), RATE_HZ).hz, hz,
                        0.005 * hz)
                << "phase " << phase;
}

TEST(Tone, IsFoundAtTheFastRateToo) {
    for (const double hz : {100.0, 440.0, 1000.0, 3500.0, 15000.0})
        EXPECT_NEAR(analyse_tone(sound(0.1, sine(hz), 48000), 48000).hz, hz, 0.005 * hz);
}

TEST(Tone, HasTheLevelOfItsAmplitude) {
    EXPECT_NEAR(analyse_tone(sound(0.1, sine(440, 32767)), RATE_HZ).level_dbfs, 0, 0.1);
    EXPECT_NEAR(analyse_tone(sound(0.1, sine(440, 3276.8)), RATE_HZ).level_dbfs, -20, 0.1);
    EXPECT_NEAR(analyse_tone(sound(0.1, sine(1234.5, 327.68)), RATE_HZ).level_dbfs, -40, 0.1);
}

TEST(Tone, HasTheEnergyOfASineAndASquareWave) {
    EXPECT_GT(analyse_tone(sound(0.1, sine(440)), RATE_HZ).share, 0.99);
    const auto square =
        sound(0.1, [](double t) { return std::fmod(t * 440, 1) < 0.5 ? 9000 : -9000; });
    EXPECT_NEAR(analyse_tone(square, RATE_HZ).share, 8 / (M_PI * M_PI), 0.02);
    EXPECT_TRUE(is_tone(square, RATE_HZ, 440, 0.005));
}

TEST(Tone, IsNotDisturbedByAConstantOffset) {
    const auto samples = sound(0.1, [](double t) { return 8000 + sine(440, 1000)(t); });
    EXPECT_NEAR(analyse_tone(samples, RATE_HZ).hz, 440, 2);
    EXPECT_TRUE(is_tone(samples, RATE_HZ, 440, 0.01));
}

TEST(Tone, MustBeWithinTheGivenFraction) {
    const auto samples = sound(0.1, sine(440));
    EXPECT_TRUE(is_tone(samples, RATE_HZ, 440, 0.005));
    EXPECT_TRUE(is_tone(samples, RATE_HZ, 430, 0.03));
    EXPECT_FALSE(is_tone(samples, RATE_HZ, 430, 0.02));
    EXPECT_FALSE(is_tone(samples, RATE_HZ, 880, 0.03));
    EXPECT_FALSE(is_tone(samples, RATE_HZ, 220, 0.03));
}

TEST(Tone, MustFillTheWholeStretch) {
    const auto late = sound(0.1, [](double t) { return t < 0.02 ? 0 : sine(440)(t); });
    const auto early = sound(0.1, [](double t) { return t > 0.08 ? 0 : sine(440)(t); });
    const auto gap = sound(0.1, [](double t) { return t > 0.04 && t < 0.07 ? 0 : sine(440)(t); });
    for (const auto& samples : {late, early, gap})
        EXPECT_FALSE(is_tone(samples, RATE_HZ, 440, 0.03));
}

TEST(Tone, MayFadeAway) {
    const auto bell = sound(0.1, [](double t) { return std::exp(-t / 0.05) * sine(440)(t); });
    EXPECT_TRUE(is_tone(bell, RATE_HZ, 440, 0.01));
}

TEST(Tone, IsNotNoise) {
    std::mt19937 random(1);
    for (int i = 0; i < 20; ++i) {
        const auto noise = sound(0.1, [&](double) { return double(random() % 20000) - 10000; });
        const double hz = analyse_tone(noise, RATE_HZ).hz;
        EXPECT_FALSE(is_tone(noise, RATE_HZ, hz, 0.03));
    }
}

TEST(Tone, IsNotSomethingTooSoft) {
    EXPECT_TRUE(is_tone(sound(0.1, sine(440, 60)), RATE_HZ, 440, 0.03));
    EXPECT_FALSE(is_tone(sound(0.1, sine(440, 20)), RATE_HZ, 440, 0.03));
}

TEST(Tone, IsNeverHeardInNothing) {
    EXPECT_EQ(analyse_tone({}, RATE_HZ).hz, 0);
    EXPECT_EQ(analyse_tone(std::vector<std::int16_t>(31, 5), RATE_HZ).hz, 0);
    EXPECT_EQ(analyse_tone(std::vector<std::int16_t>(800, 0), RATE_HZ).hz, 0);
    EXPECT_EQ(analyse_tone(std::vector<std::int16_t>(800, -123), RATE_HZ).hz, 0);
    EXPECT_FALSE(is_tone({}, RATE_HZ, 440, 0.03));
}

TEST(Tone, GivesTheSameNumbersEachTime) {
    const auto samples = sound(0.1, sine(441.7));
    const Tone a = analyse_tone(samples, RATE_HZ), b = analyse_tone(samples, RATE_HZ);
    EXPECT_EQ(a.hz, b.hz);
    EXPECT_EQ(a.level_dbfs, b.level_dbfs);
    EXPECT_EQ(a.share, b.share);
}

TEST(Silence, IsZeroAndNothingElse) {
    std::vector<std::int16_t> samples(800, 0);
    EXPECT_TRUE(is_silence(samples));
    EXPECT_TRUE(is_silence({}));
    samples[799] = 1;
    EXPECT_FALSE(is_silence(samples));
}

}  // namespace
