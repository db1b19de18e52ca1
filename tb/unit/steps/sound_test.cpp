// sound_test.cpp - expect-tone, expect-silence
#include <cmath>

#include "tb/unit/steps/step_bench.h"

namespace {

using namespace tb;
using testing::StartsWith;

class SoundSteps : public StepTest {
protected:
    double hz = 0;  // of what is heard; 0: silence
    std::uint64_t from_ms = 0;

    // 8 samples per millisecond.
    void SetUp() override {
        board.seen.sample_rate(8000);
        board.meanwhile = [&] {
            for (int i = 0; i < 8; ++i) {
                const double t = static_cast<double>(samples_++) / 8000;
                const bool on = hz > 0 && board.now_ms() > from_ms;
                const auto s =
                    static_cast<std::int16_t>(on ? 8000 * std::sin(6.2831853 * hz * t) : 0);
                board.seen.sample(s, s);
            }
        };
    }

private:
    std::uint64_t samples_ = 0;
};

TEST_F(SoundSteps, HearATone) {
    hz = 440;
    EXPECT_EQ(finds("expect-tone: {hz: 440}"), "met");
    EXPECT_EQ(board.now_ms(), 100u);
    EXPECT_EQ(finds("expect-tone: {hz: 450}"), "met");  // within 3 %
    EXPECT_THAT(finds("expect-tone: {hz: 450, within: 0.5%}"), StartsWith("440."));
}

TEST_F(SoundSteps, WaitASecondForAToneByDefault) {
    EXPECT_EQ(finds("expect-tone: {hz: 440}"), "silence");
    EXPECT_EQ(board.now_ms(), 1100u);
    EXPECT_EQ(finds("expect-tone: {hz: 440.5, within: 0.5%, for: 50ms, timeout: 0s}"), "silence");
    EXPECT_EQ(board.now_ms(), 1150u);
    hz = 440;
    from_ms = 1500;
    EXPECT_EQ(finds("expect-tone: {hz: 440}"), "met");
}

TEST_F(SoundSteps, HearNothing) {
    EXPECT_EQ(finds("expect-silence: {for: 100ms}"), "met");
    EXPECT_EQ(board.now_ms(), 100u);
    hz = 440;
    from_ms = 150;
    EXPECT_THAT(finds("expect-silence: {for: 100ms}"), StartsWith("sound after 50."));
}

TEST_F(SoundSteps, DoNotTakeAPausedCodecForSilence) {
    board.meanwhile = [] {};
    EXPECT_EQ(finds("expect-silence: {for: 100ms}"), "no samples were played");
}

TEST_F(SoundSteps, DescribeThemselves) {
    EXPECT_EQ(said("expect-tone: {hz: 440}"),
              "expect a tone of 440 Hz, give or take 3%, for 100ms within 1s");
    EXPECT_EQ(said("expect-silence: {for: 1s}"), "expect silence for 1s");
}

}  // namespace
