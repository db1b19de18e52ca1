// pins_test.cpp - set-pins, expect-pins
#include "tb/unit/scenario_errors.h"
#include "tb/unit/steps/step_bench.h"

namespace {

using namespace tb;
using testing::ElementsAre;

class PinSteps : public StepTest {};

TEST_F(PinSteps, DriveAndRelease) {
    EXPECT_THAT(acts("set-pins: {jp1: 3, level: low}"), ElementsAre("pins 8 0 0"));
    EXPECT_THAT(acts("set-pins: {jp1: [31, 0], jp2: 4, level: high}"),
                ElementsAre("pins 80000001 10 1"));
    EXPECT_THAT(acts("set-pins: {jp2: [0, 1], level: released}"), ElementsAre("pins 0 3 2"));
}

TEST_F(PinSteps, ExpectAllOfOneLevel) {
    stage.pins[0] = 0xFFFFFFF7;
    stage.pins[1] = 0x10;
    EXPECT_EQ(finds("expect-pins: {jp1: [0, 1], jp2: 4, level: high}"), "met");
    EXPECT_EQ(finds("expect-pins: {jp1: 3, jp2: [3, 5], level: low}"), "met");
    EXPECT_EQ(finds("expect-pins: {jp1: [3, 4], jp2: [4, 6, 5], level: high}"),
              "JP1 D3, JP2 D5 and D6 low");
    EXPECT_EQ(finds("expect-pins: {jp2: [4, 5], level: low}"), "JP2 D4 high");
}

TEST_F(PinSteps, WaitForALevel) {
    stage.meanwhile = [&] { stage.pins[0] = stage.now_ms() >= 25; };
    EXPECT_EQ(finds("expect-pins: {jp1: 0, level: high, timeout: 1s}"), "met");
    EXPECT_EQ(stage.now_ms(), 25u);
}

TEST_F(PinSteps, SoundLikeAPerson) {
    EXPECT_EQ(said("set-pins: {jp1: [0, 3], jp2: 4, level: high}"),
              "drive JP1 D0 and D3, JP2 D4 high");
    EXPECT_EQ(said("set-pins: {jp2: 4, level: released}"), "release JP2 D4");
    EXPECT_EQ(said("expect-pins: {jp1: 0, level: low, timeout: 1s}"),
              "expect JP1 D0 low within 1s");
}

TEST_F(PinSteps, RefuseWhatIsNoPinAndNoLevel) {
    EXPECT_EQ(step_error("set-pins: {level: high}"),
              "a.yaml:4:3: expected jp1 or jp2 in set-pins, got none");
    EXPECT_EQ(step_error("set-pins: {jp1: 32, level: high}"),
              "a.yaml:4:19: expected a pin number, 0 to 31, got 32");
    EXPECT_EQ(step_error("set-pins: {jp1: [1, 1], level: high}"),
              "a.yaml:4:23: expected each pin once, got 1 again");
    EXPECT_EQ(step_error("expect-pins: {jp1: 1, level: released}"),
              "a.yaml:4:32: expected low or high, got \"released\"");
}

}  // namespace
