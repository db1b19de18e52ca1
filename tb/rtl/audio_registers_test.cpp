// audio_registers_test.cpp - the audio core's thresholds, interrupts and byte lanes
#include "tb/rtl/audio_bench.h"

namespace {

using namespace regmap;
using namespace tb;

// ---- Thresholds and interrupts ----

// At 8 kHz there is time enough in a frame.
TEST_F(SlowAudio, RaisesWiFrom96FreePlacesOn) {
    for (const unsigned room : {128u, 97u, 96u, 95u, 94u, 0u}) {
        write(AUDIO_CONTROL, CONTROL_CW);
        write(AUDIO_CONTROL, CONTROL_RE | CONTROL_WE);
        to_frame();
        push(1, 128 - room);
        ASSERT_EQ(read(AUDIO_FIFOSPACE) >> 16, room << 8 | room);
        EXPECT_EQ(read(AUDIO_CONTROL) & CONTROL_WI, room >= 96 ? CONTROL_WI : 0u) << room;
    }
}

TEST_F(SlowAudio, RaisesWiFor96FreePlacesOnOneSideAlone) {
    for (const std::uint32_t side : {AUDIO_LEFTDATA, AUDIO_RIGHTDATA}) {
        const std::uint32_t other = side == AUDIO_LEFTDATA ? AUDIO_RIGHTDATA : AUDIO_LEFTDATA;
        write(AUDIO_CONTROL, CONTROL_CW);
        write(AUDIO_CONTROL, CONTROL_RE | CONTROL_WE);
        to_frame();
        for (unsigned n = 0; n < 50; ++n) write(other, n);
        for (unsigned n = 0; n < 32; ++n) write(side, n);
        EXPECT_EQ(read(AUDIO_CONTROL) & CONTROL_WI, CONTROL_WI) << std::hex << side;
        write(side, 0);
        EXPECT_EQ(read(AUDIO_CONTROL) & CONTROL_WI, 0u) << std::hex << side;
    }
}

TEST_F(SlowAudio, RaisesRiFor96SamplesOnOneSideAlone) {
    for (const std::uint32_t side : {AUDIO_LEFTDATA, AUDIO_RIGHTDATA}) {
        write(AUDIO_CONTROL, CONTROL_CR);
        write(AUDIO_CONTROL, CONTROL_RE | CONTROL_WE);
        clock(100 * SLOW_FRAME);
        to_frame();
        const bool left = side == AUDIO_LEFTDATA;
        while ((left ? right_waiting() : left_waiting()) > 80)
            read(left ? AUDIO_RIGHTDATA : AUDIO_LEFTDATA);
        while ((left ? left_waiting() : right_waiting()) > 96) read(side);
        EXPECT_EQ(read(AUDIO_CONTROL) & CONTROL_RI, CONTROL_RI) << std::hex << side;
        read(side);
        EXPECT_EQ(read(AUDIO_CONTROL) & CONTROL_RI, 0u) << std::hex << side;
    }
}

TEST_F(Audio, RaisesNeitherWithoutItsEnable) {
    EXPECT_EQ(read(AUDIO_CONTROL), 0u) << "there is room";
    write(AUDIO_CONTROL, CONTROL_WE);
    EXPECT_EQ(read(AUDIO_CONTROL), CONTROL_WE | CONTROL_WI);
    write(AUDIO_CONTROL, CONTROL_RE);
    EXPECT_EQ(read(AUDIO_CONTROL), CONTROL_RE);
}

TEST_F(SlowAudio, InterruptsForEachSideByItsMask) {
    const auto irqs = [this] {  // bit n: with RE, WE = n
        unsigned result = 0;
        for (std::uint32_t mask = 0; mask < 4; ++mask) {
            write(AUDIO_CONTROL, mask);
            result |= static_cast<unsigned>(dut.irq_o) << mask;
        }
        return result;
    };
    write(AUDIO_CONTROL, CONTROL_CR);
    EXPECT_EQ(irqs(), 0b1100u) << "WI alone";
    clock(100 * SLOW_FRAME);
    EXPECT_EQ(irqs(), 0b1110u) << "RI and WI";
    to_frame();
    push(1, 128);
    EXPECT_EQ(irqs(), 0b1010u) << "RI alone";
    write(AUDIO_CONTROL, CONTROL_CR);
    EXPECT_EQ(irqs(), 0b0000u) << "neither";
}

// ---- Bus ----

TEST_F(Audio, ShowsZeroOnTheBusUnlessItWasRead) {
    EXPECT_NE(read(AUDIO_FIFOSPACE), 0u);
    clock();
    EXPECT_EQ(dut.rdata_o, 0u);
    EXPECT_EQ(read(CODEC_BASE + 0xc), 0u);
}

TEST_F(Audio, DoesNothingOnAWriteWithoutAByte) {
    write(AUDIO_LEFTDATA, 1, 0);
    write(AUDIO_CONTROL, 0xf, 0);
    EXPECT_EQ(left_room(), 128u);
    EXPECT_EQ(read(AUDIO_CONTROL), 0u);
}

TEST_F(Audio, TakesTheWholeSampleWithAnyByte) {
    write(AUDIO_LEFTDATA, left_of(7), 0x1);
    write(AUDIO_RIGHTDATA, right_of(7), 0x8);
    clock(3 * FAST_FRAME);
    EXPECT_EQ(sound(), pairs(7, 7));
}

TEST_F(Audio, ChangesControlByItsByteLane) {
    write(AUDIO_CONTROL, 0xffffffff, 0xe);
    EXPECT_EQ(read(AUDIO_CONTROL), 0u);
    write(AUDIO_CONTROL, 0xffffffff, 0x1);
    EXPECT_EQ(read(AUDIO_CONTROL), 0xfu);
}

TEST_F(Audio, KeepsItsRateWhateverIsWritten) {
    const std::uint64_t words = codec.words();
    write(CODEC_RATE, 8'000);
    EXPECT_EQ(read(CODEC_RATE), 48'000u);
    clock(20'000);
    EXPECT_EQ(codec.words(), words) << "no new set-up";
}

}  // namespace
