// line_in_test.cpp - samples at the board's line-in, as a program reads them.
#include "regmap.h"
#include "tb/support/whole_board.h"

namespace {

constexpr unsigned SETUP_MS = 20;  // of the codec, by the hardware itself

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
