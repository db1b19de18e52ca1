// audio_test.cpp - what is written is heard, what is played in is read
#include "tb/rtl/audio_bench.h"

namespace {

using namespace regmap;
using namespace tb;
using ::testing::IsEmpty;

// ---- Output ----

TEST_F(Audio, PlaysWhatIsWrittenInOrder) {
    push(1, 100);
    clock(110 * FAST_FRAME);
    EXPECT_EQ(sound(), pairs(1, 100));
}

TEST_F(SlowAudio, PlaysWhatIsWrittenInOrder) {
    push(1, 100);
    clock(110 * SLOW_FRAME);
    EXPECT_EQ(sound(), pairs(1, 100));
}

TEST_F(Audio, PlaysWithoutAGapWhileTheFifosAreFed) {
    for (unsigned n = 1; n <= 1000; ++n) {
        while (left_room() < 100 || right_room() < 100) clock(FAST_FRAME);
        push(n);
    }
    clock(140 * FAST_FRAME);
    EXPECT_EQ(sound(), pairs(1, 1000));
}

TEST_F(Audio, SendsAPairOnlyWhenBothSidesHaveASample) {
    write(AUDIO_LEFTDATA, left_of(1));
    write(AUDIO_LEFTDATA, left_of(2));
    clock(5 * FAST_FRAME);
    EXPECT_EQ(left_room(), 126u);
    EXPECT_THAT(sound(), IsEmpty());
    write(AUDIO_RIGHTDATA, right_of(1));
    clock(5 * FAST_FRAME);
    EXPECT_EQ(sound(), pairs(1, 1));
    EXPECT_EQ(left_room(), 127u);
    EXPECT_EQ(right_room(), 128u);
}

TEST_F(Audio, DropsWhatIsWrittenToAFullFifo) {
    for (unsigned n = 1; n <= 135; ++n) write(AUDIO_LEFTDATA, left_of(n));
    EXPECT_EQ(left_room(), 0u);
    EXPECT_EQ(right_room(), 128u);
    to_frame();
    for (unsigned n = 1; n <= 128; ++n) write(AUDIO_RIGHTDATA, right_of(n));
    clock(140 * FAST_FRAME);
    EXPECT_EQ(sound(), pairs(1, 128));
}

TEST_F(Audio, PlaysZerosAndCountsOnceWhenTheOutputRunsDry) {
    EXPECT_EQ(read(CODEC_UNDERRUNS), 0u) << "silence before the first sample is none";
    push(1, 3);
    clock(20 * FAST_FRAME);
    EXPECT_EQ(read(CODEC_UNDERRUNS), 1u);
    EXPECT_EQ(sound(), pairs(1, 3));
    push(4);
    clock(20 * FAST_FRAME);
    EXPECT_EQ(read(CODEC_UNDERRUNS), 2u);
    write(CODEC_UNDERRUNS, 12345);
    EXPECT_EQ(read(CODEC_UNDERRUNS), 0u);
    clock(20 * FAST_FRAME);
    EXPECT_EQ(read(CODEC_UNDERRUNS), 0u);
}

// At 8 kHz frames are a whole number of clocks long, so the clock of an underrun can be foretold.
class UnderrunAt8Khz : public SlowAudio {
protected:
    // Number of the clock that counted one, while UNDERRUNS was written and read in every clock.
    std::uint64_t underrun() {
        std::vector<std::uint64_t> seen;
        push(1);
        dut.we_i = dut.re_i = 1;
        dut.waddr_i = dut.raddr_i = CODEC_UNDERRUNS & 0xfff;
        for (unsigned i = 0; i < 4 * SLOW_FRAME; ++i) {
            clock();
            EXPECT_LE(dut.rdata_o, 1u);
            if (dut.rdata_o) seen.push_back(clocks - 1);
        }
        dut.we_i = dut.re_i = 0;
        EXPECT_EQ(seen.size(), 1u) << "an underrun was cleared in its clock";
        return seen.empty() ? 0 : seen.front();
    }
    // Two underruns, and a write in the very clock of the third.
    void write_in_the_third(std::uint32_t address) {
        const std::uint64_t one = underrun();
        for (const unsigned count : {1u, 2u}) {
            push(2);
            clock(4 * SLOW_FRAME);
            ASSERT_EQ(read(CODEC_UNDERRUNS), count);
        }
        push(3);  // it leaves in the clock `one` of this frame, and the next frame has none
        clock(2 * SLOW_FRAME - 1 - (clocks - one) % SLOW_FRAME);
        write(address, 0);
        EXPECT_EQ((clocks - 1 - one) % SLOW_FRAME, 0u);
    }
};

TEST_F(UnderrunAt8Khz, IsCountedInTheClockOfAClear) {
    write_in_the_third(CODEC_UNDERRUNS);
    EXPECT_EQ(read(CODEC_UNDERRUNS), 1u);
}

TEST_F(UnderrunAt8Khz, CountsWhenAnotherRegisterIsWrittenInItsClock) {
    write_in_the_third(AUDIO_CONTROL);
    EXPECT_EQ(read(CODEC_UNDERRUNS), 3u);
}

TEST_F(Audio, HoldsTheOutputEmptyWhileCwIsSet) {
    to_frame();
    push(1, 50);
    write(AUDIO_CONTROL, CONTROL_CW);
    EXPECT_EQ(read(AUDIO_CONTROL), CONTROL_CW);
    push(51, 60);
    EXPECT_EQ(read(AUDIO_FIFOSPACE) >> 16, 0u) << "no room";
    write(AUDIO_CONTROL, CONTROL_CW | CONTROL_WE);
    EXPECT_EQ(read(AUDIO_CONTROL), CONTROL_CW | CONTROL_WE) << "no WI";
    clock(5 * FAST_FRAME);
    write(AUDIO_CONTROL, 0);
    EXPECT_EQ(read(AUDIO_FIFOSPACE) >> 16, 0x8080u);
    clock(5 * FAST_FRAME);
    EXPECT_THAT(sound(), IsEmpty());
    push(61);
    clock(5 * FAST_FRAME);
    EXPECT_EQ(sound(), pairs(61, 61));
}

// ---- Input ----

TEST_F(Audio, ReadsWhatIsPlayedIn) { read_line_in(FAST_FRAME); }

TEST_F(SlowAudio, ReadsWhatIsPlayedIn) { read_line_in(SLOW_FRAME); }

TEST_F(Audio, ReadsTheLastSampleOnceMoreFromAnEmptyFifo) {
    line_in_on = true;
    clock(5 * FAST_FRAME);
    std::uint32_t left = 0, right = 0;
    while (left_waiting()) left = read(AUDIO_LEFTDATA), right = read(AUDIO_RIGHTDATA);
    EXPECT_NE(left, 0u);
    EXPECT_EQ(read(AUDIO_LEFTDATA), left);
    EXPECT_EQ(read(AUDIO_RIGHTDATA), right);
    EXPECT_EQ(read(AUDIO_FIFOSPACE) & 0xffff, 0u);
}

TEST_F(Audio, DropsInputToAFullFifoPerSide) {
    line_in_on = true;
    write(AUDIO_CONTROL, CONTROL_CR);
    clock(2 * FAST_FRAME);
    to_frame();
    const unsigned n = line_in;
    write(AUDIO_CONTROL, 0);
    clock(150 * FAST_FRAME);
    EXPECT_EQ(read(AUDIO_FIFOSPACE) & 0xffff, 0x8080u);
    for (unsigned i = 0; i < 128; ++i) ASSERT_EQ(read(AUDIO_LEFTDATA), left_of(n + i) & ~0xffu);
    to_frame();
    const unsigned later = line_in;  // the pair of the frame that has just begun
    while (left_waiting()) read(AUDIO_LEFTDATA);
    clock(20 * FAST_FRAME);
    EXPECT_NEAR(left_waiting(), 20, 1) << "the full right side does not keep the left one back";
    EXPECT_EQ(right_waiting(), 128u);
    EXPECT_EQ(read(AUDIO_LEFTDATA), left_of(later) & ~0xffu);
    EXPECT_EQ(read(AUDIO_RIGHTDATA), right_of(n) & ~0xffu) << "the oldest";
}

TEST_F(Audio, HoldsTheInputEmptyWhileCrIsSet) {
    line_in_on = true;
    clock(20 * FAST_FRAME);
    EXPECT_GT(left_waiting(), 10u);
    write(AUDIO_CONTROL, CONTROL_CR);
    EXPECT_EQ(read(AUDIO_CONTROL), CONTROL_CR);
    clock(20 * FAST_FRAME);
    EXPECT_EQ(read(AUDIO_FIFOSPACE) & 0xffff, 0u);
    write(AUDIO_CONTROL, 0);
    clock(2 * FAST_FRAME);
    EXPECT_GT(left_waiting(), 0u);
}

}  // namespace
