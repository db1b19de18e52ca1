// codec_test.cpp - the hardware sets up the WM8731 by itself, and says when it could not.
#include "regmap.h"
#include "tb/support/whole_board.h"

namespace {

constexpr unsigned SETUP_MS = 20;

class CodecSetup : public tb::WholeBoard {};

TEST_F(CodecSetup, IsReadySoonAfterPowerOn) {
    run_to_end([](hal::Mmio& io, hal::Cpu& cpu) {
        idle_ms(cpu, SETUP_MS);
        EXPECT_EQ(io.read(regmap::CODEC_STATUS) &
                      (regmap::CODEC_STATUS_READY_MASK | regmap::CODEC_STATUS_ERROR_MASK),
                  regmap::CODEC_STATUS_READY_MASK);
        idle_ms(cpu, 5);
    });
    EXPECT_EQ(board->codec_chip.refused_words(), 0u);
    EXPECT_EQ(board->codec_chip.reg(9), 1u);  // active
    EXPECT_DOUBLE_EQ(rate_hz, 8'000);
}

TEST_F(CodecSetup, ReportsTheRefusedWordAndWorksWhenRepeated) {
    bool done = false;
    power_on([&](hal::Mmio& io, hal::Cpu& cpu) {
        idle_ms(cpu, SETUP_MS);
        EXPECT_EQ(io.read(regmap::CODEC_STATUS),
                  regmap::CODEC_STATUS_ERROR_MASK | 4u << regmap::CODEC_STATUS_STEP_LSB);
        EXPECT_EQ(board->codec_chip.reg(9), 0u);
        io.write(regmap::AV_CONFIG_CONTROL, regmap::AV_CONFIG_CONTROL_RESET_MASK);
        idle_ms(cpu, SETUP_MS);
        EXPECT_EQ(io.read(regmap::CODEC_STATUS) & 3, regmap::CODEC_STATUS_READY_MASK);
        done = true;
    });
    board->codec_chip.refuse_word(5);
    run_ms(2 * SETUP_MS + 5);
    EXPECT_TRUE(done);
    EXPECT_EQ(board->codec_chip.words(), 5u + 11u);
    EXPECT_EQ(board->codec_chip.refused_words(), 1u);
    EXPECT_DOUBLE_EQ(rate_hz, 8'000);
}

class LineIn : public tb::WholeBoard {};

TEST_F(LineIn, ComesOutOfTheFifosSampleBySample) {
    const auto recording = std::make_shared<sim::Recording>();
    for (int i = 0; i < 400; ++i)
        recording->samples.push_back({(1000 + i) << 8, -((1000 + i) << 8)});
    std::vector<std::uint32_t> left_in, right_in;
    run_to_end([&](hal::Mmio& io, hal::Cpu& cpu) {
        idle_ms(cpu, SETUP_MS);
        io.write(regmap::AUDIO_CONTROL, regmap::AUDIO_CONTROL_CR_MASK);
        io.write(regmap::AUDIO_CONTROL, 0);
        recording->rate_hz = board->codec_chip.rate_hz();
        board->line_in.play(recording, false, sc_core::sc_time_stamp().value());
        while (left_in.size() < 450) {
            cpu.idle();
            while (io.read(regmap::AUDIO_FIFOSPACE) & 0xff) {
                left_in.push_back(io.read(regmap::AUDIO_LEFTDATA));
                right_in.push_back(io.read(regmap::AUDIO_RIGHTDATA));
            }
        }
    });
    std::size_t at = 0;
    while (at < left_in.size() && left_in[at] == 0) ++at;
    ASSERT_LT(at, 10u);
    for (std::uint32_t i = 0; i < 400; ++i) {
        ASSERT_EQ(left_in[at + i], (1000 + i) << 8) << i;
        ASSERT_EQ(right_in[at + i], -((1000 + i) << 8)) << i;
    }
    EXPECT_EQ(left_in[at + 400], 0u);
}

}  // namespace
