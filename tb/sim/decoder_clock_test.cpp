// decoder_clock_test.cpp - the video decoder's clock stands still while nothing is captured
#include <gtest/gtest.h>

#include <vector>

#include "regmap.h"
#include "sim/fpga/fabric.h"
#include "tb/rtl/fabric_burst.h"

namespace {

constexpr std::uint32_t STATUS = regmap::VIDEO_IN_STATUS - 0xFF200000;

// Notes at which rises of its clock the decoder is asked for a byte.
struct Pins : sim::PinListener {
    std::vector<std::uint64_t> rises;

    std::uint8_t td_data(std::uint64_t rise) override {
        rises.push_back(rise);
        return 0x80;
    }
    void video(const std::uint32_t*, std::size_t) override {}
    void codec(const sim::CodecPins&, std::uint64_t, sim::ChipInputs&) override {}
    void headers(const sim::HeaderPins&, std::uint64_t, sim::ChipInputs&) override {}
    void adc(const sim::AdcPins&, std::uint64_t, sim::ChipInputs&) override {}
    void sdram(const sim::SdramPins&, std::uint64_t, std::uint16_t&, bool& more) override {
        more = false;
    }
    void ps2(unsigned, unsigned, std::uint64_t, sim::ChipInputs&) override {}
};

class StandingClock : public ::testing::Test {
protected:
    Pins pins;
    sim::Fabric fabric{pins};

    void capture(bool on) {
        const std::uint8_t word[4] = {static_cast<std::uint8_t>(on ? 4 : 0), 0, 0, 0};
        fabric.begin(tb::burst_of(false, true, STATUS, word, 4));
        ASSERT_TRUE(fabric.run_to_answer(fabric.time_ps() + 100 * sim::FABRIC_PERIOD_PS));
    }
    // Those that have passed by now: the first is one period, 25 / 27 clocks, after the beginning.
    double rises_by_now() const { return static_cast<double>(fabric.clocks()) * 27 / 25; }
};

TEST_F(StandingClock, DoesNotRiseUntilSomebodyCaptures) {
    fabric.run_clocks(100'000);
    EXPECT_TRUE(pins.rises.empty());
}

TEST_F(StandingClock, GoesOnWhereItWouldBeHadItNeverStood) {
    for (const unsigned pause : {10u, 1'000u, 123'457u}) {
        fabric.run_clocks(pause);
        pins.rises.clear();
        const double before = rises_by_now();
        capture(true);
        fabric.run_clocks(10'000);
        ASSERT_FALSE(pins.rises.empty());
        EXPECT_GE(static_cast<double>(pins.rises.front()), before - 2);
        EXPECT_LE(static_cast<double>(pins.rises.front()), before + 12) << "a write takes 5 clocks";
        EXPECT_NEAR(static_cast<double>(pins.rises.back()), rises_by_now(), 2);
        for (std::size_t i = 1; i < pins.rises.size(); ++i)
            ASSERT_EQ(pins.rises[i], pins.rises[i - 1] + 1);
        capture(false);
    }
}

TEST_F(StandingClock, StandsStillAFewClocksAfterTheCapture) {
    capture(true);
    fabric.run_clocks(1'000);
    capture(false);
    fabric.run_clocks(10);
    const std::size_t seen = pins.rises.size();
    fabric.run_clocks(100'000);
    EXPECT_EQ(pins.rises.size(), seen);
}

}  // namespace
