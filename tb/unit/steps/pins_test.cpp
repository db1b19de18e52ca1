// pins_test.cpp - set-pins, expect-pins
#include "tb/unit/scenario_errors.h"
#include "tb/unit/steps/step_bench.h"

namespace {

using namespace tb;
using testing::ElementsAre;

class PinSteps : public StepTest {};

TEST_F(PinSteps, DriveAndRelease) {
    EXPECT_THAT(acts("set-pins: {jp1: 3, level: low}"), ElementsAre("pins 20 0 0"));
    EXPECT_THAT(acts("set-pins: {jp1: [31, 0], jp2: 4, level: high}"),
                ElementsAre("pins 800000002 40 1"));
    EXPECT_THAT(acts("set-pins: {jp2: [13, 14, 15], level: released}"),
                ElementsAre("pins 0 A8000 2"));
}

TEST_F(PinSteps, DriveAllPinsOfAHeader) {
    EXPECT_THAT(acts("set-pins: {gpio_0: [0, 2, 16, 18, 35], gpio_1: 1, level: low}"),
                ElementsAre("pins 800050005 2 0"));
    EXPECT_THAT(acts("set-pins: {jp1: 0, gpio_0: 0, level: low}"), ElementsAre("pins 3 0 0"));
}

TEST_F(PinSteps, HaveTheArduinoHeader) {
    EXPECT_EQ(said("set-pins: {arduino_io: [0, 15], gpio_1: 1, level: low}"),
              "drive GPIO_1[1], ARDUINO_IO[0] and [15] low");
    board.pins = {0, 0, 0x0003};
    EXPECT_EQ(finds("expect-pins: {arduino_io: [0, 1], level: high}"), "met");
    EXPECT_EQ(finds("expect-pins: {arduino_io: [1, 2], level: high}"), "ARDUINO_IO[2] low");
    EXPECT_EQ(step_error("set-pins: {arduino_io: 16, level: high}"),
              "a.yaml:4:26: expected a pin number, 0 to 15, got 16");
}

TEST_F(PinSteps, ExpectAllOfOneLevel) {
    board.pins = {sim::pins_of_bits(0xFFFFFFF7), sim::pins_of_bits(0x10) | 1};
    EXPECT_EQ(finds("expect-pins: {jp1: [0, 1], jp2: 4, level: high}"), "met");
    EXPECT_EQ(finds("expect-pins: {jp1: 3, jp2: [3, 5], level: low}"), "met");
    EXPECT_EQ(finds("expect-pins: {jp1: [3, 4], jp2: [4, 6, 5], level: high}"),
              "JP1 D3, JP2 D5 and D6 low");
    EXPECT_EQ(finds("expect-pins: {jp2: [4, 5], level: low}"), "JP2 D4 high");
    EXPECT_EQ(finds("expect-pins: {gpio_0: 1, gpio_1: 0, jp2: 4, level: high}"), "met");
    EXPECT_EQ(finds("expect-pins: {jp1: 3, gpio_0: [0, 2], gpio_1: [0, 1], level: high}"),
              "JP1 D3, GPIO_0[0] and [2], GPIO_1[1] low");
}

TEST_F(PinSteps, WaitForALevel) {
    board.meanwhile = [&] { board.pins[0] = sim::pins_of_bits(board.now_ms() >= 25); };
    EXPECT_EQ(finds("expect-pins: {jp1: 0, level: high, timeout: 1s}"), "met");
    EXPECT_EQ(board.now_ms(), 25u);
}

TEST_F(PinSteps, DescribeThemselves) {
    EXPECT_EQ(said("set-pins: {jp1: [0, 3], jp2: 4, level: high}"),
              "drive JP1 D0 and D3, JP2 D4 high");
    EXPECT_EQ(said("set-pins: {jp2: 4, level: released}"), "release JP2 D4");
    EXPECT_EQ(said("set-pins: {gpio_1: [0, 35], jp1: 1, level: low}"),
              "drive JP1 D1, GPIO_1[0] and [35] low");
    EXPECT_EQ(said("expect-pins: {jp1: 0, level: low, timeout: 1s}"),
              "expect JP1 D0 low within 1s");
}

TEST_F(PinSteps, RefuseWhatIsNoPinAndNoLevel) {
    EXPECT_EQ(step_error("set-pins: {level: high}"),
              "a.yaml:4:3: expected jp1, jp2, gpio_0, gpio_1 or arduino_io in set-pins, got none");
    EXPECT_EQ(step_error("set-pins: {jp1: 32, level: high}"),
              "a.yaml:4:19: expected a pin number, 0 to 31, got 32");
    EXPECT_EQ(step_error("set-pins: {gpio_0: 36, level: high}"),
              "a.yaml:4:22: expected a pin number, 0 to 35, got 36");
    EXPECT_EQ(step_error("set-pins: {jp1: [1, 1], level: high}"),
              "a.yaml:4:23: expected each pin once, got 1 again");
    EXPECT_EQ(step_error("expect-pins: {jp1: 1, level: released}"),
              "a.yaml:4:32: expected low or high, got \"released\"");
}

}  // namespace
