// lamps_test.cpp - expect-leds, expect-hps-led, expect-hex
#include "tb/unit/steps/step_bench.h"

namespace {

using namespace tb;

class LampSteps : public StepTest {};

TEST_F(LampSteps, CompareLedsWithAPatternOrANumber) {
    board.leds = 5;
    EXPECT_EQ(finds("expect-leds: \"0000000101\""), "met");
    EXPECT_EQ(finds("expect-leds: 5"), "met");
    EXPECT_EQ(finds("expect-leds: {equals: 5}"), "met");
    EXPECT_EQ(finds("expect-leds: \"1000000000\""), "LEDR shows 0000000101");
    board.leds = 1023;
    EXPECT_EQ(finds("expect-leds: 1023"), "met");
    board.leds = 512;
    EXPECT_EQ(finds("expect-leds: \"1000000000\""), "met");
}

TEST_F(LampSteps, LookOnceOrForATime) {
    board.meanwhile = [&] { board.leds = board.now_ms() >= 40; };
    EXPECT_EQ(finds("expect-leds: 1"), "LEDR shows 0000000000");
    EXPECT_EQ(board.now_ms(), 0u);
    EXPECT_EQ(finds("expect-leds: {equals: 1, timeout: 1s}"), "met");
    EXPECT_EQ(board.now_ms(), 40u);
}

TEST_F(LampSteps, LookAtTheHpsLed) {
    EXPECT_EQ(finds("expect-hps-led: dark"), "met");
    EXPECT_EQ(finds("expect-hps-led: lit"), "it is dark");
    board.meanwhile = [&] { board.lit = board.now_ms() >= 40; };
    EXPECT_EQ(finds("expect-hps-led: {equals: lit, timeout: 1s}"), "met");
    EXPECT_EQ(board.now_ms(), 40u);
    EXPECT_EQ(finds("expect-hps-led: dark"), "it is lit");
    EXPECT_EQ(said("expect-hps-led: {equals: lit, timeout: 1s}"),
              "expect the HPS LED lit within 1s");
}

TEST_F(LampSteps, ReadSixDigitsLeftmostFirst) {
    board.segments = {0x3F, 0x3F, 0x06, 0x00, 0x00, 0x00};
    EXPECT_EQ(finds("expect-hex: \"   100\""), "met");
    EXPECT_EQ(finds("expect-hex: {equals: Error-, timeout: 10ms}"), "HEX shows \"   100\"");
    EXPECT_EQ(board.now_ms(), 10u);
}

TEST_F(LampSteps, DescribeThemselves) {
    EXPECT_EQ(said("expect-leds: 5"), "expect LEDs 0000000101");
    EXPECT_EQ(said("expect-hex: {equals: \"   100\", timeout: 1s}"),
              "expect \"   100\" on HEX within 1s");
}

}  // namespace
