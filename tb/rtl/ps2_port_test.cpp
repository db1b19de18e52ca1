// ps2_port_test.cpp - the PS/2 port's registers, with a device on its two wires.
#include <gtest/gtest.h>

#include <string>

#include "Vps2_port.h"
#include "regmap.h"
#include "tb/support/register_bus.h"

namespace {

constexpr std::uint32_t DATA = regmap::PS2_0_DATA, CONTROL = regmap::PS2_0_CONTROL,
                        RE = regmap::PS2_0_CONTROL_RE_MASK, RI = regmap::PS2_0_CONTROL_RI_MASK,
                        CE = regmap::PS2_0_CONTROL_CE_MASK, RVALID = regmap::PS2_0_DATA_RVALID_MASK;
constexpr unsigned QUARTER = 500;  // of a bit of 80 us

class Ps2Port : public tb::RegisterBus<Vps2_port> {
protected:
    bool clk_low = false, dat_low = false;  // by the device

    void SetUp() override {
        after_clock();
        reset();
        clock(100);
    }
    void after_clock() override {
        dut.ps2_clk_i = !(clk_low || dut.ps2_clk_low_o);
        dut.ps2_dat_i = !(dat_low || dut.ps2_dat_low_o);
        dut.tick_i = clocks % 32 == 0;
    }
    // One bit from the device: stable around CLK's low half.
    void device_bit(bool level) {
        dat_low = !level;
        clock(QUARTER);
        clk_low = true;
        clock(2 * QUARTER);
        clk_low = false;
        clock(QUARTER);
        dat_low = false;
    }
    // Start, eight bits, parity, stop; odd parity unless spoilt.
    void device_sends(std::uint8_t byte, bool parity_right = true, bool stop = true) {
        device_bit(false);
        bool parity = parity_right;
        for (int i = 0; i < 8; ++i) {
            device_bit(byte >> i & 1);
            parity ^= byte >> i & 1;
        }
        device_bit(parity);
        device_bit(stop);
        clock(QUARTER);
    }
    // The host asks to send: CLK low for 100 us at least, then DAT.
    void expect_request() {
        unsigned low = 0;
        while (dut.ps2_clk_low_o && low < 10'000) {
            EXPECT_EQ(dut.ps2_dat_low_o, 0);
            clock();
            ++low;
        }
        EXPECT_GE(low, 2'500u);
        EXPECT_LE(low, 5'000u);
        EXPECT_EQ(dut.ps2_dat_low_o, 1);
    }
    // Waits for the host's request, takes ten bits, acknowledges or not.  -1: no request.
    int device_takes(bool acknowledge = true) {
        for (unsigned i = 0; i < 10'000 && !(dut.ps2_dat_low_o && !dut.ps2_clk_low_o); ++i) clock();
        if (!dut.ps2_dat_low_o || dut.ps2_clk_low_o) return -1;
        int bits = 0;
        for (int bit = 0; bit < 10; ++bit) {
            clock(QUARTER);
            clk_low = true;
            clock(2 * QUARTER);
            clk_low = false;
            bits |= dut.ps2_dat_i << bit;
            clock(QUARTER);
        }
        device_bit(!acknowledge);
        return bits;
    }
};

TEST_F(Ps2Port, GivesBytesOnceWithTheNumberThatWaits) {
    for (const std::uint8_t byte : {0x1c, 0xf0, 0xff, 0x00}) device_sends(byte);
    EXPECT_EQ(read(DATA), 4u << 16 | RVALID | 0x1c);
    EXPECT_EQ(read(DATA), 3u << 16 | RVALID | 0xf0);
    EXPECT_EQ(read(DATA), 2u << 16 | RVALID | 0xff);
    EXPECT_EQ(read(DATA), 1u << 16 | RVALID | 0x00);
    EXPECT_EQ(read(DATA), 0u);
}

TEST_F(Ps2Port, ShowsTheLastByteOnceMoreWhileNoneWaits) {
    for (const std::uint8_t byte : {0x1c, 0x32}) device_sends(byte);
    read(DATA);
    read(DATA);
    EXPECT_EQ(read(DATA), 0x32u);
    EXPECT_EQ(read(DATA), 0x32u);
    device_sends(0x21);
    EXPECT_EQ(read(DATA), 1u << 16 | RVALID | 0x21);
    EXPECT_EQ(read(DATA), 0x21u);
}

TEST_F(Ps2Port, KeepsTheByteWhenOnlyTheCountIsRead) {
    device_sends(0x1c);
    EXPECT_EQ(read(DATA, false), 1u << 16 | RVALID | 0x1c);
    EXPECT_EQ(read(DATA), 1u << 16 | RVALID | 0x1c);
    EXPECT_EQ(read(DATA), 0x1cu);
}

// The core looks at neither.
TEST_F(Ps2Port, TakesBytesWithWrongParityOrWithoutAStopBit) {
    device_sends(0x55, false);
    device_sends(0x56, true, false);
    EXPECT_EQ(read(DATA), 2u << 16 | RVALID | 0x55);
    EXPECT_EQ(read(DATA), 1u << 16 | RVALID | 0x56);
}

TEST_F(Ps2Port, IgnoresSpikesOnTheClock) {
    for (int i = 0; i < 40; ++i) {
        clk_low = true;
        clock(6);
        clk_low = false;
        clock(30);
    }
    device_sends(0xa5);
    EXPECT_EQ(read(DATA), 1u << 16 | RVALID | 0xa5);
}

TEST_F(Ps2Port, BeginsAnewWhenAFrameBreaksOff) {
    for (int i = 0; i < 5; ++i) device_bit(false);
    clock(60'000);  // 2.4 ms
    device_sends(0x12);
    EXPECT_EQ(read(DATA), 1u << 16 | RVALID | 0x12);
}

TEST_F(Ps2Port, InterruptsWhileAByteWaitsIfAsked) {
    device_sends(0x1c);
    EXPECT_EQ(dut.irq_o, 0);
    EXPECT_EQ(read(CONTROL), 0u);  // RI is of an interrupt that was asked for
    write(CONTROL, RE);
    EXPECT_EQ(dut.irq_o, 1);
    EXPECT_EQ(read(CONTROL), RI | RE);
    read(DATA);
    EXPECT_EQ(dut.irq_o, 0);
    EXPECT_EQ(read(CONTROL), RE);
}

TEST_F(Ps2Port, ChangesReAndCeByTheirByteLanes) {
    write(CONTROL, RE, 0xe);
    EXPECT_EQ(read(CONTROL), 0u);
    write(CONTROL, RE, 0x1);
    EXPECT_EQ(read(CONTROL), RE);
    write(CONTROL, 0, 0xe);
    EXPECT_EQ(read(CONTROL), RE);

    write(DATA, 0xf4);
    clock(400'000);           // nobody takes it
    write(CONTROL, RE, 0xd);  // without CE's byte
    EXPECT_EQ(read(CONTROL), CE | RE);
    write(CONTROL, 0, 0x2);
    EXPECT_EQ(read(CONTROL), RE);
}

TEST_F(Ps2Port, SendsNothingWithoutTheBytesLane) {
    write(DATA, 0xf4f4f4f4, 0xe);
    EXPECT_EQ(device_takes(), -1);
    write(DATA, 0xed, 0x1);
    EXPECT_EQ(device_takes() & 0xff, 0xed);
}

TEST_F(Ps2Port, LosesNoByteToAnAccessOfControl) {
    device_sends(0x1c);
    read(CONTROL);
    write(CONTROL, 0);
    write(DATA, 0, 0);
    EXPECT_EQ(read(DATA), 1u << 16 | RVALID | 0x1c);
}

TEST_F(Ps2Port, Keeps256Bytes) {
    for (unsigned i = 0; i < 258; ++i) device_sends(static_cast<std::uint8_t>(i * 7));
    for (unsigned i = 0; i < 256; ++i)
        ASSERT_EQ(read(DATA), (256 - i) << 16 | RVALID | (i * 7 & 0xff)) << i;
    EXPECT_EQ(read(DATA), (255 * 7u) & 0xff);
}

TEST_F(Ps2Port, HoldsTheClockLowAsLongWhileAByteComes) {
    for (int i = 0; i < 5; ++i) device_bit(false);
    write(DATA, 0xf4);
    expect_request();
    EXPECT_EQ(device_takes() & 0xff, 0xf4);
    device_sends(0xfa);
    EXPECT_EQ(read(DATA), 1u << 16 | RVALID | 0xfa);  // of what came before nothing is left
}

TEST_F(Ps2Port, SendsEightBitsOddParityAndStop) {
    write(DATA, 0xf4);
    EXPECT_EQ(device_takes(), 0xf4 | 0 << 8 | 1 << 9);
    write(DATA, 0xed);
    EXPECT_EQ(device_takes(), 0xed | 1 << 8 | 1 << 9);
    EXPECT_EQ(read(CONTROL), 0u);
    EXPECT_EQ(device_takes(), -1);
}

TEST_F(Ps2Port, ClearsCeByAWriteOfAnything) {
    for (const std::uint32_t value : {0u, CE}) {
        write(DATA, 0xf4);
        clock(400'000);
        EXPECT_EQ(read(CONTROL), CE);
        write(CONTROL, value);
        EXPECT_EQ(read(CONTROL), 0u);
    }
}

// The core does not look at the acknowledge.
TEST_F(Ps2Port, SendsAByteThatTheDeviceDoesNotAcknowledge) {
    write(DATA, 0xf4);
    EXPECT_EQ(device_takes(false) & 0xff, 0xf4);
    clock(10'000);
    EXPECT_EQ(read(CONTROL), 0u);
    EXPECT_EQ(dut.wait_o, 0);
}

TEST_F(Ps2Port, TimesOutAfter2MillisecondsPerByte) {
    write(DATA, 0xf4);
    expect_request();
    for (int edge = 0; edge < 11; ++edge) {  // 0.24 ms from one to the next, 2.4 ms in all
        clk_low = true;
        clock(3'000);
        clk_low = false;
        clock(3'000);
    }
    EXPECT_EQ(read(CONTROL), CE);
}

TEST_F(Ps2Port, CountsTheTimeOfAByteFromItsFirstEdgeOn) {
    write(DATA, 0xf4);
    expect_request();
    clock(1'000);
    const std::uint64_t first = clocks;
    for (int edge = 0; edge < 9; ++edge) {
        clk_low = true;
        clock(1'000);
        clk_low = false;
        clock(1'000);
    }
    while (read(CONTROL) != CE && clocks < first + 100'000) {
    }
    EXPECT_NEAR(static_cast<double>(clocks - first), 1'563 * 32, 250);  // and the wires' filter
}

TEST_F(Ps2Port, GivesUpWhenNobodyTakesTheByteIn15Milliseconds) {
    write(DATA, 0xf4);
    clock(340'000);
    EXPECT_EQ(read(CONTROL), 0u);
    clock(30'000);
    EXPECT_EQ(dut.wait_o, 1);
    clock(20'000);
    EXPECT_EQ(dut.wait_o, 0);
    EXPECT_EQ(read(CONTROL), CE);
    EXPECT_EQ(dut.ps2_dat_low_o, 0);
    device_sends(0xaa);
    EXPECT_EQ(read(DATA), 1u << 16 | RVALID | 0xaa);
}

TEST_F(Ps2Port, MakesTheBusWaitUntilAByteHasBeenSent) {
    EXPECT_EQ(dut.wait_o, 0);
    dut.we_i = 1;
    dut.waddr_i = DATA & 0xfff;
    dut.wdata_i = 0xf4;
    dut.wstrb_i = 1;
    dut.eval();
    EXPECT_EQ(dut.wait_o, 1) << "in the clock of the write";
    clock();
    dut.we_i = 0;
    expect_request();
    EXPECT_EQ(dut.wait_o, 1);
    EXPECT_EQ(device_takes() & 0xff, 0xf4);
    clock(200);
    EXPECT_EQ(dut.wait_o, 0);
}

TEST_F(Ps2Port, WaitsUntilClkRisesAfterTheAcknowledge) {
    write(DATA, 0xf4);
    expect_request();
    for (int edge = 0; edge < 11; ++edge) {
        clock(1'000);
        clk_low = true;
        clock(1'000);
        if (edge < 10) clk_low = false;
    }
    EXPECT_EQ(dut.wait_o, 1);
    clk_low = false;
    clock(200);
    EXPECT_EQ(dut.wait_o, 0);
}

TEST_F(Ps2Port, DoesNotWaitForOtherWrites) {
    write(CONTROL, RE);
    EXPECT_EQ(dut.wait_o, 0);
    write(DATA, 0xf4, 0xe);
    EXPECT_EQ(dut.wait_o, 0);
}

}  // namespace
