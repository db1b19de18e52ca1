// audio.v with a WM8731 on its pins: what is written is heard, what is played in is read.
#include <gmock/gmock.h>

#include "Vaudio.h"
#include "regmap.h"
#include "sim/board/wm8731.h"
#include "tb/support/random_registers.h"
#include "tb/support/register_bus.h"

namespace {

using namespace regmap;
using ::testing::IsEmpty;

constexpr std::uint64_t CLOCK_PS = 40'000;
constexpr unsigned SLOW_FRAME = 3072, FAST_FRAME = 512;  // clocks
constexpr std::uint32_t CONTROL_CW = 8, CONTROL_CR = 4, CONTROL_RI = 0x100, CONTROL_WI = 0x200;

// Pair number n, n > 0: both channels differ, no sample is 0, the low 8 bits are noise.
std::uint32_t left_of(unsigned n) { return (n * 0x010203u << 8) | 0x5a; }
std::uint32_t right_of(unsigned n) { return (~(n * 0x030201u) << 8) | 0xa5; }

class Audio : public tb::RegisterBus<Vaudio> {
protected:
    using Pair = std::pair<std::uint32_t, std::uint32_t>;

    std::vector<Pair> heard;  // every frame
    unsigned line_in = 0;     // pairs played in so far
    bool line_in_on = false;
    sim::Wm8731 codec{
        [this](const sim::StereoSample& s, std::uint64_t) { heard.emplace_back(s.left, s.right); },
        [this] {
            if (!line_in_on) return sim::StereoSample{};
            ++line_in;
            return sim::StereoSample{static_cast<std::int32_t>(left_of(line_in)),
                                     static_cast<std::int32_t>(right_of(line_in))};
        }};

    static void SetUpTestSuite() { tb::start_with_random_registers(); }
    void SetUp() override {
        dut.i2c_sdat_i = 1;
        reset();
        write(CODEC_RATE, 1);
        wait_for_set_up();
        write(AUDIO_CONTROL, CONTROL_CR);  // drop the silence that has come in so far
        write(AUDIO_CONTROL, 0);
    }
    void TearDown() override { EXPECT_THAT(codec.errors(), IsEmpty()); }

    void after_clock() override {
        codec.drive({dut.aud_bclk_o != 0, dut.aud_daclrck_o != 0, dut.aud_adclrck_o != 0,
                     dut.aud_dacdat_o != 0, dut.i2c_sclk_o != 0, sda()},
                    clocks * CLOCK_PS);
        dut.aud_adcdat_i = codec.adcdat();
        dut.i2c_sdat_i = sda();
    }
    bool sda() const { return !dut.i2c_sdat_oe_o && !codec.pulls_sda_low(); }

    void wait_for_set_up() {
        for (int i = 0; i < 20'000 && !(read(CODEC_STATUS) & 3); ++i) clock(10);
        EXPECT_TRUE(read(CODEC_STATUS) & 3) << "the set-up does not end";
    }
    void rate(bool fast) {
        write(CODEC_RATE, fast);
        wait_for_set_up();
    }
    void push(unsigned n) {
        write(AUDIO_LEFTDATA, left_of(n));
        write(AUDIO_RIGHTDATA, right_of(n));
    }
    void push(unsigned first, unsigned last) {
        for (unsigned n = first; n <= last; ++n) push(n);
    }
    // To just behind the first bit of a frame; the next pair leaves nearly a frame later.
    void to_frame() {
        while (!dut.aud_daclrck_o) clock();
        while (dut.aud_daclrck_o) clock();
        while (!dut.aud_bclk_o) clock();
    }
    std::uint32_t left_room() { return read(AUDIO_FIFOSPACE) >> 24; }
    std::uint32_t right_room() { return read(AUDIO_FIFOSPACE) >> 16 & 0xff; }
    std::uint32_t left_waiting() { return read(AUDIO_FIFOSPACE) >> 8 & 0xff; }
    std::uint32_t right_waiting() { return read(AUDIO_FIFOSPACE) & 0xff; }

    // What was heard and not silence, in order; it must be in one piece.
    std::vector<Pair> sound() const {
        std::vector<Pair> result;
        bool over = false;
        for (const Pair& pair : heard) {
            if (pair == Pair{0, 0}) {
                over = !result.empty();
                continue;
            }
            EXPECT_FALSE(over) << "a gap after " << result.size() << " pairs";
            result.push_back(pair);
        }
        return result;
    }
    static std::vector<Pair> pairs(unsigned first, unsigned last) {
        std::vector<Pair> result;
        for (unsigned n = first; n <= last; ++n)
            result.emplace_back(left_of(n) & ~0xffu, right_of(n) & ~0xffu);
        return result;
    }
};

// ---- Output ----

TEST_F(Audio, PlaysWhatIsWrittenInOrderAt48Khz) {
    push(1, 100);
    clock(110 * FAST_FRAME);
    EXPECT_EQ(sound(), pairs(1, 100));
}

TEST_F(Audio, PlaysWhatIsWrittenInOrderAt8Khz) {
    rate(false);
    push(1, 100);
    clock(110 * SLOW_FRAME);
    EXPECT_EQ(sound(), pairs(1, 100));
}

TEST_F(Audio, PlaysWithoutAGapAsLongAsTheFifosAreFed) {
    for (unsigned n = 1; n <= 1000; ++n) {
        while (left_room() < 100 || right_room() < 100) clock(FAST_FRAME);
        push(n);
    }
    clock(140 * FAST_FRAME);
    EXPECT_EQ(sound(), pairs(1, 1000));
}

TEST_F(Audio, LetsAPairLeaveOnlyWhenBothSidesHoldASample) {
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

TEST_F(Audio, HoldsTheOutputEmptyWhileCwIsSet) {
    to_frame();
    push(1, 50);
    write(AUDIO_CONTROL, CONTROL_CW);
    EXPECT_EQ(read(AUDIO_CONTROL), CONTROL_CW | CONTROL_WI);
    push(51, 60);
    EXPECT_EQ(read(AUDIO_FIFOSPACE) >> 16, 0x8080u);
    clock(5 * FAST_FRAME);
    write(AUDIO_CONTROL, 0);
    clock(5 * FAST_FRAME);
    EXPECT_THAT(sound(), IsEmpty());
    push(61);
    clock(5 * FAST_FRAME);
    EXPECT_EQ(sound(), pairs(61, 61));
}

// ---- Input ----

TEST_F(Audio, ReadsWhatIsPlayedInAtBothRates) {
    for (const bool fast : {true, false}) {
        rate(fast);
        write(AUDIO_CONTROL, CONTROL_CR);
        line_in_on = true;
        clock(2 * SLOW_FRAME);
        to_frame();
        const unsigned first = line_in;  // the pair of the frame that has just begun
        write(AUDIO_CONTROL, 0);
        clock(100 * (fast ? FAST_FRAME : SLOW_FRAME));
        const std::uint32_t count = left_waiting();
        EXPECT_NEAR(count, 100, 1);
        EXPECT_EQ(right_waiting(), count);
        for (unsigned n = first; n < first + count; ++n) {
            ASSERT_EQ(read(AUDIO_LEFTDATA), left_of(n) & ~0xffu);
            ASSERT_EQ(read(AUDIO_RIGHTDATA), right_of(n) & ~0xffu);
        }
    }
}

TEST_F(Audio, ReadsZeroFromAnEmptyFifo) {
    write(AUDIO_CONTROL, CONTROL_CR);
    line_in_on = true;
    clock(5 * FAST_FRAME);
    EXPECT_EQ(read(AUDIO_FIFOSPACE) & 0xffff, 0u);
    EXPECT_EQ(read(AUDIO_LEFTDATA), 0u);
    EXPECT_EQ(read(AUDIO_RIGHTDATA), 0u);
    EXPECT_EQ(read(AUDIO_FIFOSPACE) & 0xffff, 0u);
}

TEST_F(Audio, KeepsLeftAndRightInStepWhenTheInputOverflows) {
    line_in_on = true;
    write(AUDIO_CONTROL, CONTROL_CR);
    clock(2 * FAST_FRAME);
    to_frame();
    unsigned n = line_in;
    write(AUDIO_CONTROL, 0);
    clock(150 * FAST_FRAME);
    EXPECT_EQ(read(AUDIO_FIFOSPACE) & 0xffff, 0x8080u);
    for (unsigned i = 0; i < 10; ++i) EXPECT_EQ(read(AUDIO_LEFTDATA), left_of(n + i) & ~0xffu);
    clock(20 * FAST_FRAME);  // room on the left alone: nothing may come in
    EXPECT_EQ(read(AUDIO_FIFOSPACE) & 0xffff, 118u << 8 | 128u);
    for (unsigned i = 0; i < 10; ++i) EXPECT_EQ(read(AUDIO_RIGHTDATA), right_of(n + i) & ~0xffu);
    clock(20 * FAST_FRAME);
    for (unsigned i = 10; i < 128; ++i) {
        ASSERT_EQ(read(AUDIO_LEFTDATA), left_of(n + i) & ~0xffu);
        ASSERT_EQ(read(AUDIO_RIGHTDATA), right_of(n + i) & ~0xffu);
    }
    const std::uint32_t left = read(AUDIO_LEFTDATA), right = read(AUDIO_RIGHTDATA);
    for (n = 1; n < line_in && left != (left_of(n) & ~0xffu);) ++n;
    EXPECT_EQ(right, right_of(n) & ~0xffu) << "of another pair";
}

TEST_F(Audio, HoldsTheInputEmptyWhileCrIsSet) {
    line_in_on = true;
    clock(20 * FAST_FRAME);
    EXPECT_GT(left_waiting(), 10u);
    write(AUDIO_CONTROL, CONTROL_CR);
    EXPECT_EQ(read(AUDIO_CONTROL), CONTROL_CR | CONTROL_WI);
    clock(20 * FAST_FRAME);
    EXPECT_EQ(read(AUDIO_FIFOSPACE) & 0xffff, 0u);
    write(AUDIO_CONTROL, 0);
    clock(2 * FAST_FRAME);
    EXPECT_GT(left_waiting(), 0u);
}

// ---- Thresholds and interrupts ----

TEST_F(Audio, RaisesWiFrom96FreePlacesOn) {
    for (const unsigned room : {128u, 97u, 96u, 95u, 94u, 0u}) {
        write(AUDIO_CONTROL, CONTROL_CW);
        write(AUDIO_CONTROL, 0);
        rate(false);  // time enough in a frame
        to_frame();
        push(1, 128 - room);
        ASSERT_EQ(read(AUDIO_FIFOSPACE) >> 16, room << 8 | room);
        EXPECT_EQ(read(AUDIO_CONTROL) & CONTROL_WI, room >= 96 ? CONTROL_WI : 0u) << room;
    }
}

TEST_F(Audio, RaisesWiWhenEitherSideHasTheRoom) {
    for (unsigned n = 1; n <= 33; ++n) write(AUDIO_LEFTDATA, left_of(n));
    EXPECT_EQ(left_room(), 95u);
    EXPECT_EQ(read(AUDIO_CONTROL) & CONTROL_WI, CONTROL_WI);
    write(AUDIO_CONTROL, CONTROL_CW);
    write(AUDIO_CONTROL, 0);
    for (unsigned n = 1; n <= 33; ++n) write(AUDIO_RIGHTDATA, right_of(n));
    EXPECT_EQ(right_room(), 95u);
    EXPECT_EQ(read(AUDIO_CONTROL) & CONTROL_WI, CONTROL_WI);
}

TEST_F(Audio, RaisesRiFrom96SamplesOnOnEitherSide) {
    write(AUDIO_CONTROL, CONTROL_CR);
    write(AUDIO_CONTROL, 0);
    unsigned last = 0;
    for (unsigned frames = 0; frames < 100; ++frames) {
        to_frame();
        const std::uint32_t count = left_waiting();
        EXPECT_EQ(right_waiting(), count);
        EXPECT_EQ(read(AUDIO_CONTROL) & CONTROL_RI, count >= 96 ? CONTROL_RI : 0u) << count;
        last = count;
    }
    ASSERT_GE(last, 98u);
    while (left_waiting() > 95) read(AUDIO_LEFTDATA);
    EXPECT_EQ(read(AUDIO_CONTROL) & CONTROL_RI, CONTROL_RI) << "right alone";
    while (right_waiting() > 95) read(AUDIO_RIGHTDATA);
    EXPECT_EQ(read(AUDIO_CONTROL) & CONTROL_RI, 0u);
}

TEST_F(Audio, InterruptsForEachSideByItsMask) {
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
    clock(100 * FAST_FRAME);
    EXPECT_EQ(irqs(), 0b1110u) << "RI and WI";
    rate(false);
    to_frame();
    push(1, 128);
    EXPECT_EQ(irqs(), 0b1010u) << "RI alone";
    write(AUDIO_CONTROL, CONTROL_CR);
    EXPECT_EQ(irqs(), 0b0000u) << "neither";
}

// ---- Bus ----

TEST_F(Audio, HasItsDocumentedDefaults) {
    reset();
    EXPECT_EQ(read(AUDIO_CONTROL), 0x200u);
    EXPECT_EQ(read(AUDIO_FIFOSPACE), 0x80800000u);
    EXPECT_EQ(read(CODEC_RATE), 0u);
    EXPECT_EQ(read(CODEC_STATUS), 0u);
    EXPECT_EQ(read(CODEC_UNDERRUNS), 0u);
    EXPECT_EQ(dut.irq_o, 0);
}

TEST_F(Audio, ShowsZeroOnTheBusUnlessItWasRead) {
    EXPECT_NE(read(AUDIO_FIFOSPACE), 0u);
    clock();
    EXPECT_EQ(dut.rdata_o, 0u);
    EXPECT_EQ(read(CODEC_BASE + 0xc), 0u);
}

TEST_F(Audio, DoesNothingOnAWriteWithoutAByte) {
    const std::uint64_t words = codec.words();
    write(AUDIO_LEFTDATA, 1, 0);
    write(AUDIO_CONTROL, 0xf, 0);
    write(CODEC_RATE, 0, 0);
    EXPECT_EQ(left_room(), 128u);
    EXPECT_EQ(read(AUDIO_CONTROL), CONTROL_WI);
    EXPECT_EQ(read(CODEC_RATE), 1u);
    clock(20'000);
    EXPECT_EQ(codec.words(), words) << "no new set-up";
}

TEST_F(Audio, TakesTheWholeSampleWithAnyByte) {
    write(AUDIO_LEFTDATA, left_of(7), 0x1);
    write(AUDIO_RIGHTDATA, right_of(7), 0x8);
    clock(3 * FAST_FRAME);
    EXPECT_EQ(sound(), pairs(7, 7));
}

TEST_F(Audio, ChangesControlAndRateByTheirByteLane) {
    write(AUDIO_CONTROL, 0xffffffff, 0xe);
    EXPECT_EQ(read(AUDIO_CONTROL), CONTROL_WI);
    write(AUDIO_CONTROL, 0xffffffff, 0x1);
    EXPECT_EQ(read(AUDIO_CONTROL), CONTROL_WI | 0xf);
    write(CODEC_RATE, 0, 0xe);
    EXPECT_EQ(read(CODEC_RATE), 1u);
    EXPECT_EQ(read(CODEC_STATUS) & 1, 0u) << "but it is set up again";
    wait_for_set_up();
}

// ---- Codec ----

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
