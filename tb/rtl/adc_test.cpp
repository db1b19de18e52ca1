// adc_test.cpp - the AD converter's port: rounds, registers, and the LTC2308's timing at the pins.
#include <gmock/gmock.h>

#include "Vadc.h"
#include "regmap.h"
#include "sim/board/ltc2308.h"
#include "tb/support/register_bus.h"

namespace {

using ::testing::Each;
using ::testing::ElementsAre;
using ::testing::Ge;

using regmap::ADC_CH_0, regmap::ADC_CH_1;
constexpr unsigned NEW = regmap::ADC_CH_0_NEW_MASK, VALUE = regmap::ADC_CH_0_VALUE_MASK;
constexpr unsigned ROUND = 800;  // clocks, and some
constexpr std::uint64_t CLOCK_PS = 40'000;

class Adc : public tb::RegisterBus<Vadc> {
protected:
    sim::Ltc2308 chip;
    std::vector<unsigned> words;  // six bits each, as SCK rose
    // Clocks: CONVST high; from CONVST to SCK; of SCK's period; from the sixth bit to CONVST.
    std::vector<std::uint64_t> pulses, conversions, periods, acquisitions;

    void SetUp() override {
        dut.sdo_i = 0;
        reset();
        for (unsigned n = 0; n < 8; ++n) chip.set(n, static_cast<int>(500 * n + 17));
    }
    void after_clock() override {
        watch();
        chip.drive(dut.convst_o, dut.sck_o, dut.sdi_o, clocks * CLOCK_PS);
        dut.sdo_i = chip.sdo();
    }
    std::uint32_t channel(unsigned n) { return read(static_cast<std::uint32_t>(4 * n)); }

private:
    void watch() {
        if (dut.convst_o && !convst_) {
            if (bits_ >= 6) acquisitions.push_back(clocks - sixth_);
            convst_at_ = clocks;
            bits_ = 0;
        }
        if (!dut.convst_o && convst_) pulses.push_back(clocks - convst_at_);
        if (dut.sck_o && !sck_) {
            if (bits_ == 0) {
                conversions.push_back(clocks - convst_at_);
                words.push_back(0);
            } else {
                periods.push_back(clocks - sck_at_);
            }
            sck_at_ = clocks;
            if (bits_ < 6) words.back() = words.back() << 1 | dut.sdi_o;
            if (++bits_ == 6) sixth_ = clocks;
        }
        convst_ = dut.convst_o;
        sck_ = dut.sck_o;
    }

    bool convst_ = false, sck_ = false;
    unsigned bits_ = 0;
    std::uint64_t convst_at_ = 0, sck_at_ = 0, sixth_ = 0;
};

TEST_F(Adc, StaysIdleUntilItIsWrittenTo) {
    clock(ROUND);
    EXPECT_EQ(chip.conversions(), 0u);
    EXPECT_EQ(channel(3) & NEW, 0u);
}

TEST_F(Adc, ConvertsAllChannelsOnceWhenTheFirstIsWritten) {
    write(ADC_CH_0, 0);
    clock(ROUND);
    for (unsigned n = 0; n < 8; ++n) EXPECT_EQ(channel(n), 500 * n + 17) << n;
    const std::uint64_t conversions_so_far = chip.conversions();
    clock(ROUND);
    EXPECT_EQ(chip.conversions(), conversions_so_far);
}

TEST_F(Adc, ReportsOnlyOnceThatAValueIsNew) {
    write(ADC_CH_1, 1);
    clock(ROUND + 20);
    for (const unsigned n : {5u, 4u, 7u, 0u}) {
        EXPECT_EQ(channel(n), NEW | (500 * n + 17)) << "each for itself: " << n;
        EXPECT_EQ(channel(n), 500 * n + 17) << n;
    }
    clock(ROUND);
    EXPECT_EQ(channel(5), NEW | 2517) << "again, though the same";
}

TEST_F(Adc, FlagsNewValuesOnlyInContinuousMode) {
    write(ADC_CH_0, 1);
    clock(ROUND);
    EXPECT_EQ(channel(6), 3017u);
    write(ADC_CH_1, 1);
    clock(2);
    EXPECT_EQ(channel(6), NEW | 3017u) << "of the round before";
    write(ADC_CH_1, 0);
    clock(2 * ROUND);
    EXPECT_EQ(channel(6), 3017u);
}

TEST_F(Adc, StallsAReadUntilTheRequestedRoundEnds) {
    write(ADC_CH_0, 1);
    clock(10);
    dut.re_i = 1;
    dut.raddr_i = 4 * 5;
    dut.eval();
    EXPECT_EQ(dut.rhold_o, 1);
    clock();
    dut.re_i = 0;
    unsigned waited = 0;
    for (; dut.rhold_o && waited < 2 * ROUND; ++waited) {
        EXPECT_EQ(dut.rdata_o, 0u);
        clock();
    }
    EXPECT_GT(waited, 500u);
    EXPECT_LT(waited, ROUND);
    clock();
    EXPECT_EQ(dut.rdata_o, 2517u);
    clock();
    EXPECT_EQ(dut.rdata_o, 0u);
}

TEST_F(Adc, AnswersAtOnceWhileItConvertsByItself) {
    write(ADC_CH_1, 1);
    clock(2 * ROUND + 30);
    dut.re_i = 1;
    dut.eval();
    EXPECT_EQ(dut.rhold_o, 0);
}

TEST_F(Adc, ConvertsContinuouslyBetweenAWriteOf1AndOf0) {
    write(ADC_CH_1, 1);
    clock(ROUND);
    chip.set(2, 3333);
    clock(2 * ROUND);
    EXPECT_EQ(channel(2) & VALUE, 3333u);
    write(ADC_CH_1, 0);
    clock(ROUND);
    chip.set(2, 1111);
    clock(2 * ROUND);
    EXPECT_EQ(channel(2) & VALUE, 3333u);
}

TEST_F(Adc, AsksForEachChannelSingleEndedUnipolarAndAwake) {
    write(ADC_CH_0, 0);
    clock(ROUND);
    // LTC2308, table 1: S/D O/S S1 S0, then UNI and SLP.
    ASSERT_EQ(words.size(), 9u);
    words.pop_back();
    EXPECT_THAT(words, ElementsAre(0b100010, 0b110010, 0b100110, 0b110110, 0b101010, 0b111010,
                                   0b101110, 0b111110));
}

TEST_F(Adc, KeepsToTheChipsTimes) {
    write(ADC_CH_1, 1);
    clock(3 * ROUND);
    EXPECT_THAT(pulses, Each(1u)) << "40 ns: at least 20, and over before the conversion";
    EXPECT_THAT(conversions, Each(Ge(1'600'000 / CLOCK_PS))) << "1.6 us at most";
    EXPECT_THAT(periods, Each(Ge(1u))) << "40 MHz at most";
    EXPECT_THAT(acquisitions, Each(Ge(240'000 / CLOCK_PS))) << "240 ns at least";
    EXPECT_EQ(chip.disturbed(), 0u);
    EXPECT_GT(acquisitions.size(), 20u);
}

TEST_F(Adc, IgnoresAWriteDuringARound) {
    write(ADC_CH_0, 0);
    clock(150);
    write(ADC_CH_0, 0);
    clock(2 * ROUND);
    EXPECT_EQ(chip.conversions(), 9u);
}

TEST_F(Adc, IsAskedForARoundByTheFirstChannelAlone) {
    for (std::uint32_t other = 0x08; other < 0x20; other += 4) {
        const std::uint64_t before = chip.conversions();
        dut.we_i = 1;
        dut.wdata_i = 0;
        dut.wstrb_i = 0xf;
        dut.waddr_i = ADC_CH_0 & 0xfff;
        clock();
        dut.waddr_i = other;  // in the clock in which the round begins
        clock();
        dut.we_i = 0;
        clock(2 * ROUND);
        EXPECT_EQ(chip.conversions(), before + 9) << other;
    }
}

TEST_F(Adc, ReportsThatChannelsAreNewWhenTheRoundIsOver) {
    write(ADC_CH_1, 1);
    clock(690);
    for (unsigned n = 0; n < 8; ++n) EXPECT_EQ(channel(n) & NEW, 0u) << n;
    clock(100);
    for (unsigned n = 0; n < 8; ++n) EXPECT_EQ(channel(n) & NEW, NEW) << n;
}

}  // namespace
