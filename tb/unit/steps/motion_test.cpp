// motion_test.cpp - tilt-board, accelerate-board
#include "tb/unit/steps/step_bench.h"

namespace {

using namespace tb;

class MotionSteps : public StepTest {
protected:
    std::string felt(const std::string& step) {
        acts(step);
        const auto [x, y, z] = board.motion.felt;
        return fmt::format("{:.2f} {:.2f} {:.2f} g", x, y, z);
    }
};

TEST_F(MotionSteps, TiltTheBoard) {
    EXPECT_EQ(felt("tilt-board: {right: 30}"), "-0.50 0.00 0.87 g");
    EXPECT_EQ(felt("tilt-board: {right: -90}"), "1.00 0.00 0.00 g");
    EXPECT_EQ(felt("tilt-board: {towards: 90}"), "-0.00 1.00 0.00 g");
    EXPECT_EQ(felt("tilt-board: {right: 180}"), "-0.00 0.00 -1.00 g");
    EXPECT_EQ(said("tilt-board: {right: 5, towards: -2.5}"),
              "tilt the board 5 degrees to the right and -2.5 towards you");
}

TEST_F(MotionSteps, AccelerateTheBoard) {
    EXPECT_EQ(felt("accelerate-board: {x: 0.5}"), "0.50 0.00 1.00 g");
    EXPECT_EQ(felt("accelerate-board: {x: 0, y: -2, z: 0}"), "0.00 -2.00 0.00 g");
}

}  // namespace
