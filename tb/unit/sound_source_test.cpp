// sound_source_test.cpp - what the codec gets at its input, sample by sample.
#include "sim/board/sound_source.h"

#include <cmath>

#include <gtest/gtest.h>

namespace {

using namespace sim;

constexpr std::uint64_t SAMPLE_PS = 125'000'000;  // 8 kHz
constexpr std::uint64_t BEGIN_PS = 7 * SAMPLE_PS + 33'000'000;

class SoundAtTheCodec : public testing::Test {
protected:
    SoundSource source;
    std::uint64_t now_ps = 0;

    std::int32_t left() {
        now_ps += SAMPLE_PS;
        return source.sample(now_ps, 8000).left;
    }
    // Plays 1, 2 ... count from BEGIN_PS on.
    void play(int count, bool for_ever) {
        Recording r{8000, {}};
        for (int i = 1; i <= count; ++i) r.samples.push_back({i, -i});
        source.play(std::make_shared<Recording>(r), for_ever, BEGIN_PS);
    }
};

TEST_F(SoundAtTheCodec, IsSilenceUntilItBegins) {
    EXPECT_EQ(left(), 0);
    play(100, false);
    while (now_ps < BEGIN_PS - SAMPLE_PS) EXPECT_EQ(left(), 0);
    EXPECT_EQ(left(), 1);
    EXPECT_EQ(source.sample(now_ps += SAMPLE_PS, 8000).right, -2);
}

TEST_F(SoundAtTheCodec, IsEverySampleOnceThenSilence) {
    play(1000, false);
    now_ps = 7 * SAMPLE_PS;
    for (int i = 1; i <= 1000; ++i) ASSERT_EQ(left(), i);
    EXPECT_EQ(left(), 0);
    EXPECT_EQ(left(), 0);
}

TEST_F(SoundAtTheCodec, HasEverySampleOnceWithAFastCodec) {
    play(100'000, false);
    now_ps = 7 * SAMPLE_PS;
    for (int i = 1; i <= 100'000; ++i) {
        now_ps += SAMPLE_PS - 10'000;
        ASSERT_EQ(source.sample(now_ps, 8000).left, i);
    }
}

TEST_F(SoundAtTheCodec, BeginsAgainWhereAsked) {
    play(3, true);
    now_ps = 7 * SAMPLE_PS;
    for (int i = 0; i < 20; ++i) EXPECT_EQ(left(), i % 3 + 1);
}

TEST_F(SoundAtTheCodec, HasGoneOnAfterTheCodecPaused) {
    play(1000, false);
    now_ps = 7 * SAMPLE_PS;
    EXPECT_EQ(left(), 1);
    now_ps += 500 * SAMPLE_PS;
    EXPECT_EQ(left(), 502);
}

TEST_F(SoundAtTheCodec, IsATone) {
    source.tone(1000, 0.5, SAMPLE_PS);
    const double half = 0.5 * 0x7fffffff, root = std::sqrt(0.5);
    for (const double expected : {0.0, root, 1.0, root, 0.0, -root, -1.0, -root, 0.0})
        EXPECT_NEAR(left(), half * expected, 2) << expected;
}

TEST_F(SoundAtTheCodec, IsWhatWasPlayedLast) {
    source.tone(1000, 0.5, 0);
    play(10, false);
    now_ps = 7 * SAMPLE_PS;
    EXPECT_EQ(left(), 1);
    source.silence();
    EXPECT_EQ(left(), 0);
    source.play(std::make_shared<Recording>(), true, 0);  // an empty one
    EXPECT_EQ(left(), 0);
}

TEST_F(SoundAtTheCodec, IsSilenceWhileTheRateIsNotKnown) {
    play(10, true);
    EXPECT_EQ(source.sample(BEGIN_PS + SAMPLE_PS, 0).left, 0);
}

}  // namespace
