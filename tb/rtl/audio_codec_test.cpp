// audio_codec_test.cpp - the codec is set up, at either rate, and says so
#include "tb/rtl/audio_bench.h"

namespace {

using namespace regmap;
using namespace tb;
using ::testing::IsEmpty;

TEST_F(Audio, RunsTheCodecWithin2PercentOf8And48Khz) {
    clock(5 * FAST_FRAME);
    EXPECT_NEAR(codec.rate_hz(), 48'000, 960);
    EXPECT_DOUBLE_EQ(codec.rate_hz(), 25e6 / 512);
    rate(false);
    clock(5 * SLOW_FRAME);
    EXPECT_NEAR(codec.rate_hz(), 8'000, 160);
    EXPECT_DOUBLE_EQ(codec.rate_hz(), 25e6 / 3072);
}

TEST_F(Audio, ChangesTheClocksAtOnceAndSetsTheCodecUpAgain) {
    const std::uint64_t words = codec.words();
    write(CODEC_RATE, 0);
    EXPECT_EQ(read(CODEC_STATUS) & 3, 0u);
    clock(4 * SLOW_FRAME);
    EXPECT_DOUBLE_EQ(codec.rate_hz(), 25e6 / 3072);
    EXPECT_EQ(read(CODEC_STATUS) & 3, 0u) << "still under way";
    wait_for_set_up();
    EXPECT_EQ(read(CODEC_STATUS), 0xa1u);
    EXPECT_GE(codec.words(), words + 11);
    EXPECT_EQ(codec.reg(8), 0x00c);
}

class AudioAfterPowerOn : public Audio {
protected:
    void SetUp() override {
        dut.i2c_sdat_i = 1;
        reset();
    }
};

TEST_F(AudioAfterPowerOn, IsSilentUntilTheCodecIsSetUpAndHeardAfterwards) {
    write(CODEC_RATE, 1);
    push(1, 20);
    clock(30 * FAST_FRAME);
    EXPECT_GE(heard.size(), 28u) << "silence has samples too";
    EXPECT_THAT(sound(), IsEmpty());
    wait_for_set_up();
    push(1, 20);
    clock(30 * FAST_FRAME);
    EXPECT_EQ(sound(), pairs(1, 20));
}

TEST_F(Audio, ReportsAWordThatTheCodecRefusesAndSucceedsOnASecondTry) {
    for (std::uint32_t step = 0; step < 11; ++step) {
        const std::uint64_t refused = codec.refused_words();
        codec.refuse_word(codec.words() + step + 1);
        rate(true);
        EXPECT_EQ(read(CODEC_STATUS), step << 4 | CODEC_STATUS_ERROR_MASK);
        EXPECT_EQ(codec.refused_words(), refused + 1);
        rate(true);
        EXPECT_EQ(read(CODEC_STATUS), 10u << 4 | CODEC_STATUS_READY_MASK);
    }
    push(1, 5);
    clock(10 * FAST_FRAME);
    EXPECT_EQ(sound(), pairs(1, 5));
}

TEST_F(Audio, ReportsACodecThatIsNotThere) {
    codec.refuse_word(codec.words() + 1);
    rate(true);
    EXPECT_EQ(read(CODEC_STATUS), CODEC_STATUS_ERROR_MASK);
    clock(50'000);
    EXPECT_EQ(read(CODEC_STATUS), CODEC_STATUS_ERROR_MASK);
}

}  // namespace
