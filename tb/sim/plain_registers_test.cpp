// plain_registers_test.cpp - which registers may be read or written again and again without effect
#include <gtest/gtest.h>

#include "regmap.h"
#include "sim/chip/computer.h"

namespace {

TEST(PlainOutput, HasPortsButNoCapturedEdge) {
    EXPECT_TRUE(sim::is_plain_output(regmap::LEDR_DATA, 0x3FF));
    EXPECT_TRUE(sim::is_plain_output(regmap::HEX5_4_DATA, 0x3F));
    EXPECT_TRUE(sim::is_plain_output(regmap::JP1_DIR, 0xF0));
    EXPECT_TRUE(sim::is_plain_output(sim::Peripherals::GPIO1_BASE, 1 << 24));
    EXPECT_TRUE(sim::is_plain_output(regmap::KEY_EDGE, 0));
    EXPECT_FALSE(sim::is_plain_output(regmap::KEY_EDGE, 0xF));
    EXPECT_FALSE(sim::is_plain_output(regmap::AUDIO_LEFTDATA, 0));
    EXPECT_FALSE(sim::is_plain_output(regmap::SYSID_ID, 0));
}

TEST(PlainInput, IsWhatKeepsItsBytesAndItsFlags) {
    EXPECT_TRUE(sim::is_plain_input(regmap::KEY_DATA, 1));
    EXPECT_TRUE(sim::is_plain_input(regmap::KEY_EDGE, 0xF));
    EXPECT_TRUE(sim::is_plain_input(regmap::TIMER0_STATUS, 3));
    EXPECT_TRUE(sim::is_plain_input(regmap::PS2_0_DATA, 0x55));
    EXPECT_FALSE(sim::is_plain_input(regmap::PS2_0_DATA, 0x18055)) << "a byte is removed";
    EXPECT_FALSE(sim::is_plain_input(regmap::JTAG_UART1_DATA, 0x8041));
    EXPECT_FALSE(sim::is_plain_input(regmap::AUDIO_LEFTDATA, 0)) << "a sample is removed";
    EXPECT_TRUE(sim::is_plain_input(regmap::ADC_CH_0, 0x123));
    EXPECT_FALSE(sim::is_plain_input(regmap::ADC_CH_0, 0x8123)) << "it is no longer new";
}

TEST(PlainInput, IsInTheHpsWhatChangesAtEventsAlone) {
    EXPECT_TRUE(sim::is_plain_input(0xFFFEC60C, 0)) << "private timer, status";
    EXPECT_FALSE(sim::is_plain_input(0xFFFEC604, 0)) << "... its counter";
    EXPECT_FALSE(sim::is_plain_input(0xFFFEC10C, 0x3FF)) << "the interrupt controller's ICCIAR";
    EXPECT_TRUE(sim::is_plain_input(0xFFC02014, 0x60)) << "UART0, line status";
    EXPECT_FALSE(sim::is_plain_input(0xFFC02014, 0x62)) << "... an overrun is cleared";
}

}  // namespace
