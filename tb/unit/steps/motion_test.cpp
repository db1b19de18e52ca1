// motion_test.cpp - tilt-board, accelerate-board
#include "tb/unit/steps/step_bench.h"

namespace {

using namespace tb;
using testing::ElementsAre;

class MotionSteps : public StepTest {};

TEST_F(MotionSteps, TiltTheBoard) {
    EXPECT_THAT(acts("tilt-board: {right: 30}"), ElementsAre("-0.50 0.00 0.87 g"));
    EXPECT_THAT(acts("tilt-board: {right: -90}"), ElementsAre("1.00 0.00 0.00 g"));
    EXPECT_THAT(acts("tilt-board: {towards: 90}"), ElementsAre("-0.00 1.00 0.00 g"));
    EXPECT_THAT(acts("tilt-board: {right: 180}"), ElementsAre("-0.00 0.00 -1.00 g"));
    EXPECT_EQ(said("tilt-board: {right: 5, towards: -2.5}"),
              "tilt the board 5 degrees to the right and -2.5 towards you");
}

TEST_F(MotionSteps, AccelerateTheBoard) {
    EXPECT_THAT(acts("accelerate-board: {x: 0.5}"), ElementsAre("0.50 0.00 1.00 g"));
    EXPECT_THAT(acts("accelerate-board: {x: 0, y: -2, z: 0}"), ElementsAre("0.00 -2.00 0.00 g"));
}

}  // namespace
