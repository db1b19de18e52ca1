// irda_test.cpp - the IrDA port: bytes as light by the Serial Infrared standard, and its registers.
#include <gmock/gmock.h>

#include "Virda.h"
#include "regmap.h"
#include "tb/support/register_bus.h"

namespace {

using ::testing::DoubleNear;
using ::testing::Each;

constexpr std::uint32_t DATA = regmap::IRDA_DATA, CONTROL = regmap::IRDA_CONTROL,
                        VALID = regmap::IRDA_DATA_RVALID_MASK, RI = regmap::IRDA_CONTROL_RI_MASK,
                        WI = regmap::IRDA_CONTROL_WI_MASK;
constexpr double CLOCK_US = 0.04, BIT_US = 1e6 / 115'200;

class Irda : public tb::RegisterBus<Virda> {
protected:
    std::vector<double> pulses, begins;  // of the light that is sent, in microseconds
    bool mirror = false;                 // in front of the LED

    void SetUp() override {
        dut.rxd_i = 1;
        reset();
        clock(4);
    }
    void after_clock() override {
        const double now = static_cast<double>(clocks) * CLOCK_US;
        if (dut.txd_o && !lit_) begins.push_back(now);
        if (!dut.txd_o && lit_) pulses.push_back(now - begins.back());
        lit_ = dut.txd_o;
        if (mirror) dut.rxd_i = !lit_;
    }
    void wait_us(double us) { clock(static_cast<std::uint64_t>(us / CLOCK_US + 0.5)); }
    // A sender's byte: a pulse of `pulse_us` at the beginning of each bit that is 0.
    void light(std::uint8_t byte, double pulse_us = BIT_US * 3 / 16) {
        const unsigned bits = static_cast<unsigned>(byte) << 1 | 0x200u;
        for (unsigned bit = 0; bit < 10; ++bit) {
            dut.rxd_i = bits >> bit & 1;
            wait_us(pulse_us);
            dut.rxd_i = 1;
            wait_us(BIT_US - pulse_us);
        }
    }
    std::uint32_t available() { return read(DATA) >> 16; }
    std::uint32_t space() { return read(CONTROL) >> 16; }

private:
    bool lit_ = false;
};

// The standard's receivers take pulses of 1.41 to 2.23 us at this rate.
TEST_F(Irda, TakesEveryByteWithShortAndLongPulses) {
    for (const double pulse_us : {1.41, 1.63, 2.23})
        for (unsigned byte = 0; byte < 256; ++byte) {
            light(static_cast<std::uint8_t>(byte), pulse_us);
            wait_us(5);
            ASSERT_EQ(read(DATA), 1u << 16 | VALID | byte) << pulse_us;
        }
}

TEST_F(Irda, KeepsBytesThatFollowEachOtherInTheirOrder) {
    for (unsigned n = 0; n < 100; ++n) light(static_cast<std::uint8_t>(37 * n + 1));
    wait_us(20);
    for (unsigned n = 0; n < 100; ++n)
        ASSERT_EQ(read(DATA), (100 - n) << 16 | VALID | (37 * n + 1) % 256);
    EXPECT_EQ(read(DATA), (37 * 99 + 1) % 256u) << "empty: the last byte, not valid";
}

// The output of a remote control's receiver: 562.5 us are 64.8 bits.
TEST_F(Irda, TakesALongLightForBytesOfZeros) {
    dut.rxd_i = 0;
    wait_us(562.5);
    dut.rxd_i = 1;
    wait_us(200);
    for (unsigned n = 0; n < 6; ++n) ASSERT_EQ(read(DATA), (7 - n) << 16 | VALID);
    EXPECT_EQ(read(DATA), 1u << 16 | VALID | 0xf0) << "start and four bits of light, four of dark";
    EXPECT_EQ(read(DATA), 0xf0u);
}

TEST_F(Irda, Keeps128BytesAndDropsTheNext) {
    for (unsigned n = 0; n < 130; ++n) light(static_cast<std::uint8_t>(n));
    wait_us(20);
    for (unsigned n = 0; n < 128; ++n) ASSERT_EQ(read(DATA), (128 - n) << 16 | VALID | n);
    EXPECT_EQ(read(DATA), 127u);
}

TEST_F(Irda, InterruptsFrom96BytesOnIfRiIsEnabled) {
    write(CONTROL, 1);
    for (unsigned n = 0; n < 95; ++n) light(1);
    wait_us(20);
    EXPECT_FALSE(dut.irq_o);
    EXPECT_EQ(read(CONTROL), 0x800001u);
    light(1);
    wait_us(20);
    EXPECT_TRUE(dut.irq_o);
    EXPECT_EQ(read(CONTROL), 0x800001u | RI);
    write(CONTROL, 0);
    EXPECT_EQ(read(CONTROL), 0x800000u);
    clock();
    EXPECT_FALSE(dut.irq_o);
    write(CONTROL, 1);
    clock(2);
    EXPECT_TRUE(dut.irq_o);
    read(DATA);
    clock(2);
    EXPECT_FALSE(dut.irq_o) << "95 are left";
}

TEST_F(Irda, InterruptsWhileThereIsRoomFor96IfWiIsEnabled) {
    write(CONTROL, 2);
    clock(2);
    EXPECT_TRUE(dut.irq_o);
    EXPECT_EQ(read(CONTROL), 0x800002u | WI);
    for (unsigned n = 0; n < 34; ++n) write(DATA, n);  // one is on its way
    clock(2);
    EXPECT_EQ(space(), 95u);
    EXPECT_FALSE(dut.irq_o);
    wait_us(10 * BIT_US);
    EXPECT_EQ(space(), 96u);
    EXPECT_TRUE(dut.irq_o);
}

TEST_F(Irda, SendsAPulseForTheStartAndEachZero) {
    write(DATA, 0x0f);
    wait_us(12 * BIT_US);
    ASSERT_EQ(begins.size(), 5u);
    EXPECT_THAT(pulses, Each(DoubleNear(1.64, CLOCK_US / 2))) << "three sixteenths of a bit";
    for (unsigned n = 1; n < 5; ++n)  // bits 4 to 7 after the start bit
        EXPECT_NEAR(begins[n] - begins[0], (4 + n) * BIT_US, 0.02);
}

TEST_F(Irda, HearsWhatItSends) {
    mirror = true;
    for (unsigned n = 0; n < 120; ++n) write(DATA, 91 * n % 256);
    wait_us(121 * 10 * BIT_US + 100);
    for (unsigned n = 0; n < 120; ++n)
        ASSERT_EQ(read(DATA), (120 - n) << 16 | VALID | 91 * n % 256);
    EXPECT_EQ(space(), 128u);
}

TEST_F(Irda, DropsAByteWhen128Wait) {
    mirror = true;
    for (unsigned n = 0; n < 131; ++n) write(DATA, n);  // the first is on its way
    EXPECT_EQ(space(), 0u);
    wait_us(50 * 10 * BIT_US);
    while (available()) {
    }
    wait_us(81 * 10 * BIT_US);
    std::uint32_t last = 0;
    for (std::uint32_t word; (word = read(DATA)) & VALID;) last = word & 0xff;
    EXPECT_EQ(last, 128u);
}

TEST_F(Irda, LooksAtTheLowByteLaneAlone) {
    write(DATA, 0x55, 0xe);
    write(CONTROL, 3, 0xe);
    EXPECT_EQ(read(CONTROL), 0x800000u);
}

}  // namespace
