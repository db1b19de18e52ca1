// audio_codec_test.cpp - the codec is set up, at either rate, and says so
#include "tb/rtl/audio_bench.h"

namespace {

using namespace regmap;
using namespace tb;
using ::testing::IsEmpty;

TEST_F(Audio, GivesTheCodec48000SamplesASecond) {
    clock(5 * FAST_FRAME);
    EXPECT_NEAR(codec.rate_hz(), 48'000, 0.001);  // a picosecond in 20.8 us
    EXPECT_EQ(read(CODEC_RATE), 48'000u);
    EXPECT_EQ(codec.reg(8), 0x000) << "SR = 0000: 48 kHz from 12.288 MHz";
}

TEST_F(SlowAudio, GivesTheCodec8000SamplesASecond) {
    clock(5 * SLOW_FRAME);
    EXPECT_DOUBLE_EQ(codec.rate_hz(), 8'000);
    EXPECT_EQ(read(CODEC_RATE), 8'000u);
    EXPECT_EQ(codec.reg(8), 0x00c) << "SR = 0011: 8 kHz from 12.288 MHz";
}

// In 25,000,000 clocks, a second.
TEST_F(SlowAudio, DoesNotDrift) {
    const std::size_t before = heard.size();
    clock(25'000'000);
    EXPECT_EQ(heard.size() - before, 8'000u);
}

TEST_F(Audio, ReportsTheWordThatTheCodecRefuses) {
    codec.refuse_word(codec.words() + 6);
    set_up_again();
    EXPECT_EQ(read(CODEC_STATUS), 5u << 4 | CODEC_STATUS_ERROR_MASK);
    set_up_again();
    EXPECT_EQ(read(CODEC_STATUS), 10u << 4 | CODEC_STATUS_READY_MASK);
}

class AudioAfterPowerOn : public Audio {
protected:
    void SetUp() override { power_on(48'000); }
};

TEST_F(AudioAfterPowerOn, HasItsDocumentedDefaults) {
    EXPECT_EQ(read(AUDIO_CONTROL), 0u);
    EXPECT_EQ(read(AUDIO_FIFOSPACE), 0x80800000u);
    EXPECT_EQ(read(CODEC_STATUS), 0u);
    EXPECT_EQ(read(CODEC_UNDERRUNS), 0u);
    EXPECT_EQ(dut.irq_o, 0);
    EXPECT_FALSE(sent);
}

TEST_F(AudioAfterPowerOn, IsSilentUntilTheCodecIsSetUp) {
    push(1, 20);
    clock(30 * FAST_FRAME);
    EXPECT_GE(heard.size(), 28u) << "silence has samples too";
    EXPECT_THAT(sound(), IsEmpty());
    wait_for_set_up();
    push(1, 20);
    clock(30 * FAST_FRAME);
    EXPECT_EQ(sound(), pairs(1, 20));
}

}  // namespace
