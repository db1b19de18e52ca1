// codec_setup.v: the words on the wire, worked out by hand from the WM8731's register map.
#include <gmock/gmock.h>

#include "Vcodec_setup.h"
#include "tb/rtl/i2c_bus.h"
#include "tb/support/random_registers.h"

namespace {

using ::testing::ElementsAreArray;
using ::testing::IsEmpty;

// A word is register << 9 | value.
//   R15 = 0x000   reset
//   R6  = 0x062   CLKOUTPD (6), OSCPD (5), MICPD (1); on: OUT (4), DAC (3), ADC (2), LINEIN (0)
//   R0, R1 = 0x017   volume 10111 = 0 dB, not muted (7)
//   R2, R3 = 0x079   volume 1111001 = 0 dB, no zero-cross (7)
//   R4  = 0x012   DACSEL (4), MUTEMIC (1); off: SIDETONE (5), BYPASS (3), INSEL (2) = line
//   R5  = 0x000   DACMU (3) off, no de-emphasis
//   R7  = 0x00a   slave (6 = 0), 24 bits (3:2 = 10), I2S (1:0 = 10)
//   R8  = SR (5:2): 0011 = 8 kHz -> 0x00c, 0000 = 48 kHz -> 0x000; BOSR (1) 0, normal (0) 0
//   R9  = 0x001   active
constexpr std::uint16_t SLOW[] = {0x1e00, 0x0c62, 0x0017, 0x0217, 0x0479, 0x0679,
                                  0x0812, 0x0a00, 0x0e0a, 0x100c, 0x1201};
constexpr std::uint16_t FAST[] = {0x1e00, 0x0c62, 0x0017, 0x0217, 0x0479, 0x0679,
                                  0x0812, 0x0a00, 0x0e0a, 0x1000, 0x1201};
constexpr std::size_t WORDS = std::size(SLOW);
constexpr int WORD_CLOCKS = 10'000;  // more than a word takes

class CodecSetup : public ::testing::Test {
protected:
    static void SetUpTestSuite() { tb::start_with_random_registers(); }
    void SetUp() override {
        dut.rst_i = 1;
        dut.restart_i = 0;
        dut.send_i = 0;
        dut.fast_i = 0;
        dut.sdat_i = 1;
        dut.clk_i = 0;
        dut.eval();
        dut.clk_i = 1;
        dut.eval();
        dut.rst_i = 0;
    }
    void TearDown() override { EXPECT_THAT(bus.faults, IsEmpty()); }

    void clock(int count = 1) {
        while (count--) {
            dut.clk_i = 0;
            dut.eval();
            dut.clk_i = 1;
            dut.eval();
            bus.step(dut.sclk_o, dut.sdat_oe_o);
            dut.sdat_i = bus.sda();
        }
    }
    void restart() {
        dut.restart_i = 1;
        clock();
        dut.restart_i = 0;
    }
    void finish() {
        for (std::size_t i = 0; i < WORDS * WORD_CLOCKS && !dut.ready_o && !dut.error_o; ++i)
            clock();
        EXPECT_TRUE(dut.ready_o || dut.error_o) << "no end";
    }
    std::vector<std::uint16_t> words(std::size_t first = 0) const {
        std::vector<std::uint16_t> all;
        for (std::size_t i = first; i < bus.transfers.size(); ++i)
            if (bus.transfers[i].size() == 3 && bus.transfers[i][0] == 0x34)
                all.push_back(
                    static_cast<std::uint16_t>(bus.transfers[i][1] << 8 | bus.transfers[i][2]));
        return all;
    }

    Vcodec_setup dut;
    tb::I2cBus bus;
};

TEST_F(CodecSetup, SetsTheCodecUpFor8KhzAfterReset) {
    finish();
    EXPECT_TRUE(dut.ready_o);
    EXPECT_FALSE(dut.error_o);
    EXPECT_THAT(words(), ElementsAreArray(SLOW));
    clock(5 * WORD_CLOCKS);
    EXPECT_EQ(bus.transfers.size(), WORDS) << "and then leaves it alone";
}

TEST_F(CodecSetup, SetsTheCodecUpFor48KhzWhenFast) {
    dut.fast_i = 1;
    finish();
    EXPECT_THAT(words(), ElementsAreArray(FAST));
}

TEST_F(CodecSetup, ReportsWhichWordIsOnTheWire) {
    for (std::size_t i = 0; !dut.ready_o && i < WORDS * WORD_CLOCKS; ++i) {
        clock();
        if (!bus.transfers.empty() && !bus.idle()) {
            ASSERT_EQ(dut.step_o, bus.transfers.size() - 1);
        }
    }
    EXPECT_EQ(dut.step_o, 10);
}

TEST_F(CodecSetup, StopsAtAWordThatIsRefusedAndReportsWhich) {
    finish();
    for (std::size_t word = 0; word < WORDS; ++word) {
        const std::size_t first = bus.transfers.size();
        bus.refuse(first + word, word % 3);
        restart();
        finish();
        EXPECT_TRUE(dut.error_o);
        EXPECT_FALSE(dut.ready_o);
        EXPECT_EQ(dut.step_o, word);
        clock(3 * WORD_CLOCKS);
        EXPECT_EQ(bus.transfers.size(), first + word + 1) << "and then is silent";
        EXPECT_TRUE(dut.error_o);
    }
    const std::size_t first = bus.transfers.size();
    restart();
    EXPECT_FALSE(dut.error_o);
    finish();
    EXPECT_TRUE(dut.ready_o);
    EXPECT_THAT(words(first), ElementsAreArray(SLOW)) << "and tries again when restarted";
}

TEST_F(CodecSetup, RepeatsEverythingAtARestart) {
    finish();
    dut.fast_i = 1;
    restart();
    EXPECT_FALSE(dut.ready_o) << "not ready from the very next clock on";
    finish();
    EXPECT_TRUE(dut.ready_o);
    EXPECT_THAT(words(WORDS), ElementsAreArray(FAST));
}

// Restarts at many clocks within the time of two words.  The word on the wire must be completed,
// and the last words must be a whole set-up.
TEST_F(CodecSetup, EndsTheWordOnTheWireBeforeItBeginsAgain) {
    for (int wait = 0; wait < 2 * 7400; wait += 397) {
        finish();
        restart();
        clock(wait);
        restart();
        EXPECT_FALSE(dut.ready_o);
        finish();
        EXPECT_TRUE(dut.ready_o);
        ASSERT_THAT(words(bus.transfers.size() - WORDS), ElementsAreArray(SLOW)) << wait;
        for (const auto& transfer : bus.transfers) ASSERT_EQ(transfer.size(), 3u);
    }
}

TEST_F(CodecSetup, RestartsAtTheEndOfAWord) {
    for (int early = -3; early <= 3; ++early) {
        finish();
        restart();
        const std::size_t first = bus.transfers.size();
        const unsigned stops = bus.stops;
        int length = 0;  // of a word, once
        while (bus.stops == stops && length < WORD_CLOCKS) clock(), ++length;
        clock(length - 2 + early);
        restart();
        finish();
        EXPECT_TRUE(dut.ready_o);
        EXPECT_GT(bus.transfers.size(), first + WORDS);
        ASSERT_THAT(words(bus.transfers.size() - WORDS), ElementsAreArray(SLOW)) << early;
    }
}

}  // namespace
