// gamepad_test.cpp - press-pad-button, hold-pad-button, release-pad-button, move-stick
#include "tb/unit/scenario_errors.h"
#include "tb/unit/steps/step_bench.h"

namespace {

using namespace tb;
using testing::ElementsAre;

class GamepadSteps : public StepTest {
protected:
    static std::string error(const std::string& steps, const std::string& usb = "gamepad") {
        return error_of("name: a\nversion: 1\nusb: " + usb + "\nsteps:\n- " + steps);
    }
    // With gamepads from the beginning.
    std::vector<std::string> plays(const std::string& steps, const std::string& usb = "gamepad") {
        const auto scenario = sim::parse_scenario(
            "name: a\nversion: 1\nusb: " + usb + "\nsteps:\n- " + steps + "\n", "a.yaml");
        for (const sim::UsbPlugged& one : scenario.usb.all) board.usb.device(one).plug(true);
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
                ElementsAre("pad 128 128 128 128 0 -1", "pad 128 128 128 128 1 -1",
                            "pad 128 128 128 128 1 0"));
}

TEST_F(GamepadSteps, MoveAStickThatStaysThere) {
    EXPECT_THAT(plays("move-stick: {stick: left, right: -100, down: 100}"),
                ElementsAre("pad 0 255 128 128 0 0"));
    EXPECT_EQ(said_, "move the left stick to -100% right and 100% down");
}

TEST_F(GamepadSteps, LetAStickSpringBackAfterATime) {
    EXPECT_THAT(plays("move-stick: {stick: right, right: 50, for: 1s}"),
                ElementsAre("pad 128 128 191 128 0 0", "wait 1s", "pad 128 128 128 128 0 0"));
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
              "a.yaml:6:3: expected a control that is free, got A on the first gamepad, held since "
              "line 5 (overlapping times)");
    EXPECT_EQ(error("release-pad-button: A"),
              "a.yaml:5:3: expected a control that is held, got A on the gamepad, which is not");
}

TEST_F(GamepadSteps, NumberTheButtonsOfASnesGamepadAsThatDoes) {
    EXPECT_THAT(
        plays("press-pad-button: X\n- press-pad-button: Start\n- press-pad-button: Left",
              "snes-gamepad"),
        ElementsAre("snes button 0 down", "wait 100ms", "snes button 0 up", "snes button 9 down",
                    "wait 100ms", "snes button 9 up", "snes 0 127", "wait 100ms", "snes 127 127"));
}

TEST_F(GamepadSteps, RefuseWhatASnesGamepadHasNot) {
    EXPECT_EQ(error("press-pad-button: L2", "snes-gamepad"),
              "a.yaml:5:3: expected a button of a snes-gamepad: A, B, X, Y, L, R, Select, Start, "
              "Up, Down, Left or Right, got L2");
    EXPECT_EQ(error("move-stick: {stick: left, right: 1}", "snes-gamepad"),
              "a.yaml:5:3: expected a gamepad with sticks, got a snes-gamepad, which has none");
}

const char* const TWO = "[gamepad, snes-gamepad]";

TEST_F(GamepadSteps, ActOnTheGamepadThatTheyName) {
    EXPECT_THAT(plays("hold-pad-button: {button: A, pad: 2}\n- hold-pad-button: {button: A, pad: 1}"
                      "\n- release-pad-button: {button: A, pad: 2}\n- release-pad-button: A",
                      TWO),
                ElementsAre("snes 2 button 1 down", "pad button 0 down", "snes 2 button 1 up",
                            "pad button 0 up"));
    EXPECT_THAT(plays("move-stick: {stick: left, right: 100, pad: 2}", "[gamepad, gamepad]"),
                ElementsAre("pad 2 255 128 128 128 0 0"));
    EXPECT_EQ(said_, "move the left stick of the second gamepad to 100% right and 0% down");
    EXPECT_THAT(plays("press-pad-button: {button: B, pad: 1, for: 5ms}"),
                ElementsAre("pad button 1 down", "wait 5ms", "pad button 1 up"));
    EXPECT_EQ(said_, "press B on the first gamepad for 5ms");
}

TEST_F(GamepadSteps, LetGoOfAButtonOfAGamepadThatWasUnplugged) {
    plays("hold-pad-button: Up\n- unplug-usb: gamepad\n- release-pad-button: Up");
    EXPECT_EQ(board.usb.gamepads[0].axes().back(), 0);
}

TEST_F(GamepadSteps, RefuseAStepThatDoesNotSayWhichGamepad) {
    EXPECT_EQ(error("press-pad-button: A", TWO),
              "a.yaml:5:3: expected pad: 1 or pad: 2 in the step, as two gamepads are in USB "
              "ports, got neither");
    EXPECT_EQ(error("hold-pad-button: {button: A, pad: 1}\n- hold-pad-button: {button: A, pad: 2}\n"
                    "- release-pad-button: A",
                    TWO),
              "a.yaml:7:3: expected pad: 1 or pad: 2 in the step, as it is held on two gamepads, "
              "got neither");
    EXPECT_EQ(error("press-pad-button: {button: A, pad: 2}"),
              "a.yaml:5:3: expected a gamepad that is in a USB port: pad: 1, got pad: 2");
    EXPECT_EQ(error("press-pad-button: {button: A, pad: 3}"),
              "a.yaml:5:38: expected the number of a gamepad, 1 or 2, got 3");
    EXPECT_EQ(error("unplug-usb: gamepad\n- press-pad-button: L", TWO), "no error");
}

}  // namespace
