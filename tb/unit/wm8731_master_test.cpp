// The WM8731 model as bus master: BCLK and LRCKs by the datasheet's tables of sampling rates.
#include <string>
#include <vector>

#include <gmock/gmock.h>

#include "tb/unit/wm8731_bench.h"

namespace {

using namespace tb;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

class Wm8731Master : public Wm8731Bench {
protected:
    unsigned adc_edges = 0, dac_edges = 0, bclk_edges = 0;

    // XCK of this frequency, and R8; the chip is made active last.
    void begin(unsigned r8, double xck_hz, unsigned r7 = MASTER | LEFT | BITS16) {
        set(8, r8);
        set_up(r7);
        chip.xck(static_cast<std::uint64_t>(1e15 / xck_hz));
    }

    // The wires as the board has them, where the FPGA drives none.
    void wires() {
        pins.bclk = chip.clocks().bclk;
        pins.daclrck = chip.clocks().daclrck;
        pins.adclrck = chip.clocks().adclrck;
    }
    // Until `us` have passed; `data` is the FPGA's answer to each edge.
    template <class Data>
    void run(double us, Data data) {
        for (const std::uint64_t begin = now_ps; now_ps < begin + us * 1e6;) {
            const auto was = chip.clocks();
            chip.bclk_edge();
            ++bclk_edges;
            dac_edges += was.daclrck != chip.clocks().daclrck;
            adc_edges += was.adclrck != chip.clocks().adclrck;
            wires();
            pins.dacdat = data();
            drive(was.bclk_half_fs / 1000);
        }
    }
    void run(double us) {
        run(us, [] { return false; });
    }
};

// ---- The tables of sampling rates: normal mode and USB mode ----

struct Rate {
    double adc_khz, dac_khz, xck_mhz;
    unsigned bosr, sr;
    bool usb;
};

constexpr bool USB = true, NORMAL = false;
const Rate RATES[] = {{48, 48, 12.288, 0, 0, NORMAL},
                      {48, 48, 18.432, 1, 0, NORMAL},
                      {48, 8, 12.288, 0, 1, NORMAL},
                      {48, 8, 18.432, 1, 1, NORMAL},
                      {8, 48, 12.288, 0, 2, NORMAL},
                      {8, 48, 18.432, 1, 2, NORMAL},
                      {8, 8, 12.288, 0, 3, NORMAL},
                      {8, 8, 18.432, 1, 3, NORMAL},
                      {32, 32, 12.288, 0, 6, NORMAL},
                      {32, 32, 18.432, 1, 6, NORMAL},
                      {96, 96, 12.288, 0, 7, NORMAL},
                      {96, 96, 18.432, 1, 7, NORMAL},
                      {44.1, 44.1, 11.2896, 0, 8, NORMAL},
                      {44.1, 44.1, 16.9344, 1, 8, NORMAL},
                      {44.1, 8.018, 11.2896, 0, 9, NORMAL},
                      {44.1, 8.018, 16.9344, 1, 9, NORMAL},
                      {8.018, 44.1, 11.2896, 0, 10, NORMAL},
                      {8.018, 44.1, 16.9344, 1, 10, NORMAL},
                      {8.018, 8.018, 11.2896, 0, 11, NORMAL},
                      {8.018, 8.018, 16.9344, 1, 11, NORMAL},
                      {88.2, 88.2, 11.2896, 0, 15, NORMAL},
                      {88.2, 88.2, 16.9344, 1, 15, NORMAL},
                      {48, 48, 12, 0, 0, USB},
                      {44.118, 44.118, 12, 1, 8, USB},
                      {48, 8, 12, 0, 1, USB},
                      {44.118, 8.021, 12, 1, 9, USB},
                      {8, 48, 12, 0, 2, USB},
                      {8.021, 44.118, 12, 1, 10, USB},
                      {8, 8, 12, 0, 3, USB},
                      {8.021, 8.021, 12, 1, 11, USB},
                      {32, 32, 12, 0, 6, USB},
                      {96, 96, 12, 0, 7, USB},
                      {88.235, 88.235, 12, 1, 15, USB}};

TEST_F(Wm8731Master, HasTheRatesOfTheDatasheet) {
    for (const Rate& rate : RATES)
        for (const unsigned halved : {0u, 1u}) {
            SCOPED_TRACE(::testing::Message() << rate.xck_mhz << " MHz, BOSR " << rate.bosr
                                              << ", SR " << rate.sr << ", CLKIDIV2 " << halved);
            begin(halved << 6 | rate.sr << 2 | rate.bosr << 1 | (rate.usb ? 1 : 0),
                  rate.xck_mhz * 1e6);
            const double divided = halved ? 2 : 1, us = 100'000;
            bclk_edges = dac_edges = adc_edges = 0;
            run(us);
            EXPECT_NEAR(dac_edges / us * 500, rate.dac_khz / divided, 0.02);
            EXPECT_NEAR(adc_edges / us * 500, rate.adc_khz / divided, 0.02);
            const double bclk_mhz = rate.usb ? 12 : rate.sr < 8 ? 3.072 : 2.8224;
            EXPECT_NEAR(bclk_edges / us / 2, bclk_mhz / divided, 0.001);
        }
    EXPECT_THAT(chip.errors(), IsEmpty());
}

TEST_F(Wm8731Master, ReportsRatesThatAreNotInTheTables) {
    begin(4 << 2, 12.288e6);
    run(100);
    EXPECT_THAT(chip.errors(), ElementsAre(HasSubstr("R8 = 0x010: not a rate")));
    EXPECT_NEAR(chip.rate_hz(), 48'000, 1) << "taken as the base rate";
    for (const unsigned wrong : {5 << 2, 12 << 2, 14 << 2, 8 << 2 | 1, 0 << 2 | 3}) {
        const std::uint64_t before = chip.error_count();
        set(8, wrong);
        EXPECT_GT(chip.error_count(), before) << wrong;
    }
}

TEST_F(Wm8731Master, Has187And188BclksInAFrameOf375) {
    begin(6 << 2 | 1, 12e6);
    std::vector<unsigned> high, low;
    run(200);
    while (chip.clocks().daclrck) run(0.001);
    for (int frame = 0; frame < 2; ++frame) {
        bclk_edges = 0;
        while (!chip.clocks().daclrck) run(0.001);
        low.push_back(bclk_edges / 2);
        bclk_edges = 0;
        while (chip.clocks().daclrck) run(0.001);
        high.push_back(bclk_edges / 2);
    }
    EXPECT_THAT(high, ElementsAre(187, 187));
    EXPECT_EQ(low.back(), 188u);
}

// ---- When it drives, and when its clocks run ----

TEST_F(Wm8731Master, DrivesItsClocksOnlyIfMsIsSet) {
    chip.xck(80'000'000);
    set_up(LEFT | BITS16);
    EXPECT_FALSE(chip.clocks().driven);
    EXPECT_EQ(chip.clocks().bclk_half_fs, 0u);
    set(7, MASTER | LEFT | BITS16);
    EXPECT_TRUE(chip.clocks().driven);
    EXPECT_EQ(chip.clocks().bclk_half_fs, 160'000'000u) << "a quarter of 12.5 MHz";
    set(15, 0);
    EXPECT_FALSE(chip.clocks().driven);
}

TEST_F(Wm8731Master, ItsClocksStandStillWithoutXckPowerOrActivation) {
    set_up(MASTER | LEFT | BITS16);
    EXPECT_EQ(chip.clocks().bclk_half_fs, 0u) << "no XCK";
    chip.xck(80'000'000);
    EXPECT_NE(chip.clocks().bclk_half_fs, 0u);
    set(9, 0);
    EXPECT_EQ(chip.clocks().bclk_half_fs, 0u);
    set(9, 1);
    set(6, 0x080);
    EXPECT_EQ(chip.clocks().bclk_half_fs, 0u);
    set(6, 0);
    EXPECT_NE(chip.clocks().bclk_half_fs, 0u);
    chip.xck(0);
    EXPECT_EQ(chip.clocks().bclk_half_fs, 0u);
    EXPECT_TRUE(chip.clocks().driven);
}

TEST_F(Wm8731Master, LrckMovesWhereABitEnds) {
    for (const unsigned inverted : {0u, BCLKINV}) {
        begin(0, 12.288e6, MASTER | LEFT | BITS16 | inverted);
        for (int i = 0; i < 1000; ++i) {
            const auto was = chip.clocks();
            run(0.001);
            if (was.daclrck != chip.clocks().daclrck) {
                EXPECT_EQ(chip.clocks().bclk, inverted != 0);
            }
        }
    }
}

TEST_F(Wm8731Master, PlaysWhatComesAfterItsEdges) {
    for (const bool rising : {false, true}) {  // the FPGA moves data when BCLK falls, or rises
        begin(0, 12.5e6);
        std::string frame = binary(0x80010000, 32) + binary(0x7ffe0000, 32);
        std::size_t at = 0;
        bool lrck = false;
        run(200, [&] {
            if (chip.clocks().bclk != rising) return pins.dacdat;
            const bool begins = chip.clocks().daclrck && !lrck;
            lrck = chip.clocks().daclrck;
            at = begins ? rising : at + 1;
            return frame[at % 64] == '1';
        });
        EXPECT_EQ(heard.back(), (Heard{0x80010000, 0x7ffe0000})) << rising;
        EXPECT_NEAR(chip.rate_hz(), 48'828, 1);
    }
    EXPECT_THAT(chip.errors(), IsEmpty());
}

TEST_F(Wm8731Master, ReportsOnceThatBothSidesDriveTheClocks) {
    begin(0, 12.5e6);
    pins.clocks_driven = true;
    run(100);
    EXPECT_THAT(chip.errors(), ElementsAre(HasSubstr("but the FPGA drives BCLK or LRCK, too")));
    EXPECT_EQ(chip.error_count(), 1u);
}

// ---- Why nothing is heard ----

TEST_F(Wm8731Master, ReportsWhyItIsSilent) {
    EXPECT_EQ(chip.silence(), "") << "nobody uses it";
    pins.dacdat = true;
    drive(1000);
    EXPECT_THAT(chip.silence(), HasSubstr("never activated"));
    set_up(MASTER | LEFT | BITS16);
    EXPECT_THAT(chip.silence(), HasSubstr("XCK stands still"));
    set(7, LEFT | BITS16);
    EXPECT_THAT(chip.silence(), HasSubstr("nothing drives BCLK"));
    set(5, 0x008);
    set(7, MASTER | LEFT | BITS16);
    chip.xck(80'000'000);
    run(100);
    EXPECT_THAT(chip.silence(), HasSubstr("R5 = 0x008"));
    set(5, 0);
    run(100);
    EXPECT_EQ(chip.silence(), "");
}

}  // namespace
