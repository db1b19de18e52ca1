// gamepad_test.cpp - press-pad-button, hold-pad-button, release-pad-button, move-stick
#include "tb/unit/scenario_errors.h"
#include "tb/unit/steps/step_bench.h"

namespace {

using namespace tb;
using testing::ElementsAre;

class GamepadSteps : public StepTest {
protected:
    static std::string error(const std::string& steps) {
        return error_of("name: a\nversion: 1\nusb: gamepad\nsteps:\n- " + steps);
    }
    // With a gamepad from the beginning.
    std::vector<std::string> plays(const std::string& steps) {
        const auto scenario = sim::parse_scenario(
            "name: a\nversion: 1\nusb: gamepad\nsteps:\n- " + steps + "\n", "a.yaml");
        for (const sim::ScenarioStep& step : scenario.steps) {
            step.step->play(board);
            said_ = step.text;
        }
        return std::exchange(board.done, {});
    }

    std::string said_;  // by the last
};

TEST_F(GamepadSteps, PressAButtonFor100MillisecondsByDefault) {
    EXPECT_THAT(plays("press-pad-button: A"),
                ElementsAre("pad button 0 down", "wait 100ms", "pad button 0 up"));
    EXPECT_THAT(plays("press-pad-button: {button: Start, for: 20ms}"),
                ElementsAre("pad button 11 down", "wait 20ms", "pad button 11 up"));
    EXPECT_EQ(said_, "press Start on the gamepad for 20ms");
}

TEST_F(GamepadSteps, HoldDirectionsTogether) {
    EXPECT_THAT(plays("hold-pad-button: Up\n- hold-pad-button: Right\n- release-pad-button: Up"),
                ElementsAre("pad 128 128 128 128, 0 -1", "pad 128 128 128 128, 1 -1",
                            "pad 128 128 128 128, 1 0"));
}

TEST_F(GamepadSteps, MoveAStickThatStaysThere) {
    EXPECT_THAT(plays("move-stick: {stick: left, right: -100, down: 100}"),
                ElementsAre("pad 0 255 128 128, 0 0"));
    EXPECT_EQ(said_, "move the left stick to -100% right and 100% down");
}

TEST_F(GamepadSteps, LetAStickSpringBackAfterATime) {
    EXPECT_THAT(plays("move-stick: {stick: right, right: 50, for: 1s}"),
                ElementsAre("pad 128 128 191 128, 0 0", "wait 1s", "pad 128 128 128 128, 0 0"));
    EXPECT_EQ(said_, "move the right stick to 50% right and 0% down for 1s");
}

TEST_F(GamepadSteps, NeedAGamepad) {
    for (const char* step :
         {"press-pad-button: A", "hold-pad-button: Up", "move-stick: {stick: left, right: 1}"})
        EXPECT_EQ(step_error(step), "a.yaml:4:3: expected a gamepad in a USB port, got none");
}

TEST_F(GamepadSteps, RefuseWhatAGamepadHasNot) {
    EXPECT_EQ(error("press-pad-button: Stat"),
              "a.yaml:5:21: expected a button of a gamepad: A, Start, Up and so on, got \"Stat\" "
              "(did you mean \"Start\"?)");
    EXPECT_EQ(error("move-stick: {stick: left, right: 101}"),
              "a.yaml:5:36: expected a percentage from -100 to 100, got 101");
    EXPECT_EQ(error("hold-pad-button: A\n- press-pad-button: A"),
              "a.yaml:6:3: expected a control that is free, got A on the gamepad, held since line "
              "5 (overlapping times)");
}

}  // namespace
