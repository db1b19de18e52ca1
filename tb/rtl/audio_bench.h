// audio_bench.h - audio.v with a WM8731 on its pins; the test plays into line-in and records
// line-out
#pragma once

#include <gmock/gmock.h>

#include "Vaudio.h"
#include "regmap.h"
#include "sim/board/wm8731.h"
#include "sim/fpga/asynchronous_clock.h"
#include "tb/support/random_registers.h"
#include "tb/support/register_bus.h"

namespace tb {

constexpr unsigned SLOW_FRAME = 3125, FAST_FRAME = 521;  // clocks, the last one in part
constexpr std::uint32_t CONTROL_RE = 1, CONTROL_WE = 2, CONTROL_CR = 4, CONTROL_CW = 8,
                        CONTROL_RI = 0x100, CONTROL_WI = 0x200;

// Pair number n, n > 0: both channels differ, no sample is 0, the low 8 bits are noise.
inline std::uint32_t left_of(unsigned n) { return (n * 0x010203u << 8) | 0x5a; }
inline std::uint32_t right_of(unsigned n) { return (~(n * 0x030201u) << 8) | 0xa5; }

// At 48,000 samples per second.
class Audio : public RegisterBus<Vaudio> {
protected:
    using Pair = std::pair<std::uint32_t, std::uint32_t>;

    std::vector<Pair> heard;  // every frame
    unsigned line_in = 0;     // pairs played in so far
    sim::AsynchronousClock audio_clock = sim::audio_clock(8'000);
    bool line_in_on = false;
    bool sent = false;  // a bit, since the reset
    sim::Wm8731 codec{
        [this](const sim::StereoSample& s, std::uint64_t) { heard.emplace_back(s.left, s.right); },
        [this] {
            if (!line_in_on) return sim::StereoSample{};
            ++line_in;
            return sim::StereoSample{static_cast<std::int32_t>(left_of(line_in)),
                                     static_cast<std::int32_t>(right_of(line_in))};
        }};

    static void SetUpTestSuite() { start_with_random_registers(); }
    void SetUp() override { begin(48'000); }
    void begin(unsigned rate_hz) {
        power_on(rate_hz);
        wait_for_set_up();
        write(regmap::AUDIO_CONTROL, CONTROL_CR);  // drop the silence that has come in so far
        write(regmap::AUDIO_CONTROL, 0);
    }
    void TearDown() override { EXPECT_THAT(codec.errors(), ::testing::IsEmpty()); }

    void power_on(unsigned rate_hz) {
        audio_clock = sim::audio_clock(rate_hz);
        dut.fast_i = rate_hz == 48'000;
        dut.i2c_sdat_i = 1;
        dut.rst_i = dut.rst_audio_i = 1;
        dut.we_i = dut.re_i = 0;
        clock(100);
        dut.rst_audio_i = 0;
        clock(4);
        dut.rst_i = 0;
    }
    void after_clock() override {
        drive(clocks * sim::FABRIC_PERIOD_PS);
        for (; audio_clock.clocks() <= clocks; audio_clock.next()) {
            dut.clk_audio_i = audio_clock.rises();
            dut.aud_adcdat_i = codec.adcdat();
            dut.eval();
            drive(audio_clock.time_ps());
        }
    }
    void drive(std::uint64_t time_ps) {
        codec.drive({dut.aud_bclk_o != 0, dut.aud_daclrck_o != 0, dut.aud_adclrck_o != 0,
                     dut.aud_dacdat_o != 0, dut.i2c_sclk_o != 0, sda()},
                    time_ps);
        dut.i2c_sdat_i = sda();
        sent |= dut.aud_dacdat_o && !dut.rst_audio_i;
    }
    bool sda() const { return !dut.i2c_sdat_oe_o && !codec.pulls_sda_low(); }

    void wait_for_set_up() {
        for (int i = 0; i < 20'000 && !(read(regmap::CODEC_STATUS) & 3); ++i) clock(10);
        EXPECT_TRUE(read(regmap::CODEC_STATUS) & 3) << "the set-up does not end";
    }
    void set_up_again() {
        write(regmap::AV_CONFIG_CONTROL, regmap::AV_CONFIG_CONTROL_RESET_MASK);
        clock();
        wait_for_set_up();
    }
    void push(unsigned n) {
        write(regmap::AUDIO_LEFTDATA, left_of(n));
        write(regmap::AUDIO_RIGHTDATA, right_of(n));
    }
    void push(unsigned first, unsigned last) {
        for (unsigned n = first; n <= last; ++n) push(n);
    }
    // To just after the first bit of a frame; the next pair leaves the FIFOs 7/8 of a frame later.
    void to_frame() {
        while (!dut.aud_daclrck_o) clock();
        while (dut.aud_daclrck_o) clock();
        while (!dut.aud_bclk_o) clock();
    }
    // A hundred frames of line-in, each `frame` clocks long.
    void read_line_in(unsigned frame) {
        write(regmap::AUDIO_CONTROL, CONTROL_CR);
        line_in_on = true;
        clock(2 * frame);
        to_frame();
        const unsigned first = line_in;  // the pair of the frame that has just begun
        write(regmap::AUDIO_CONTROL, 0);
        clock(100 * frame);
        const std::uint32_t count = left_waiting();
        EXPECT_NEAR(count, 100, 1);
        EXPECT_EQ(right_waiting(), count);
        for (unsigned n = first; n < first + count; ++n) {
            ASSERT_EQ(read(regmap::AUDIO_LEFTDATA), left_of(n) & ~0xffu);
            ASSERT_EQ(read(regmap::AUDIO_RIGHTDATA), right_of(n) & ~0xffu);
        }
    }
    std::uint32_t left_room() { return read(regmap::AUDIO_FIFOSPACE) >> 24; }
    std::uint32_t right_room() { return read(regmap::AUDIO_FIFOSPACE) >> 16 & 0xff; }
    std::uint32_t left_waiting() { return read(regmap::AUDIO_FIFOSPACE) >> 8 & 0xff; }
    std::uint32_t right_waiting() { return read(regmap::AUDIO_FIFOSPACE) & 0xff; }

    // The part of the output that is not silence, in order; it must be contiguous.
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

class SlowAudio : public Audio {
protected:
    void SetUp() override { begin(8'000); }
};

}  // namespace tb
