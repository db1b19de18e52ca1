// keyboard_test.cpp - type-keys, press-key, hold-key, release-key
#include "tb/unit/scenario_errors.h"
#include "tb/unit/steps/step_bench.h"

namespace {

using namespace tb;
using testing::ElementsAre;
using testing::StartsWith;

class KeyboardSteps : public StepTest {};

TEST_F(KeyboardSteps, TypeWhatAKeyboardHas) {
    acts("type-keys: \"Hi\\n\"");
    board.wait(sim::SimTime{2'000'000'000'000});  // its self-test comes first
    EXPECT_THAT(board.done, ElementsAre("wait 2s", "key 0012 down", "key 0033 down", "key 0033 up",
                                        "key 0012 up", "key 0043 down", "key 0043 up",
                                        "key 005A down", "key 005A up"));
    EXPECT_EQ(said("type-keys: 'Hi!'"), "type \"Hi!\" on the keyboard");
}

TEST_F(KeyboardSteps, PressAKeyFor100MillisecondsByDefault) {
    EXPECT_THAT(acts("press-key: Left"), ElementsAre("key E06B down", "wait 100ms", "key E06B up"));
    EXPECT_THAT(acts("press-key: {key: Esc, for: 1s}"),
                ElementsAre("key 0076 down", "wait 1s", "key 0076 up"));
}

TEST_F(KeyboardSteps, TakeAKeyByTheCharacterThatItMakes) {
    for (const auto& [name, down] : {std::pair{"a", "key 001C down"},
                                     {"A", "key 001C down"},
                                     {"1", "key 0016 down"},
                                     {"'1'", "key 0016 down"},
                                     {"';'", "key 004C down"},
                                     {"'\\'", "key 005D down"}})
        EXPECT_THAT(acts(std::string{"hold-key: "} + name), ElementsAre(down)) << name;
}

TEST_F(KeyboardSteps, PressAChordInOrderAndReleaseInReverse) {
    EXPECT_THAT(acts("press-key: [Ctrl, RightAlt, Delete]"),
                ElementsAre("key 0014 down", "key E011 down", "key E071 down", "wait 100ms",
                            "key E071 up", "key E011 up", "key 0014 up"));
    EXPECT_EQ(said("press-key: [Ctrl, c]"), "press Ctrl and c on the keyboard for 100ms");
}

TEST_F(KeyboardSteps, HoldAndRelease) {
    EXPECT_EQ(said("hold-key: [Shift, Up]"), "hold Shift and Up on the keyboard");
    const auto s = sim::parse_scenario(
        "name: a\nversion: 1\nsteps:\n- hold-key: [Shift, Up]\n- release-key: Up\n", "a.yaml");
    s.steps.at(1).step->play(board);
    EXPECT_THAT(board.done, ElementsAre("key E075 up"));
}

TEST_F(KeyboardSteps, RefuseWhatIsNoKeyOrNotFree) {
    EXPECT_EQ(step_error("press-key: Lefft"),
              "a.yaml:4:14: expected a key: Left, Esc, F1, Ctrl, RightCtrl, Numpad5 and so on, or "
              "the character that it makes, got \"Lefft\" (did you mean \"Left\"?)");
    EXPECT_THAT(step_error("press-key: '!'"), StartsWith("a.yaml:4:14: expected a key: "));
    EXPECT_EQ(step_error("press-key: [Up, Up]"),
              "a.yaml:4:19: expected each key once, got \"Up\" again");
    EXPECT_EQ(step_error("hold-key: Up\n- press-key: Up"),
              "a.yaml:5:3: expected a control that is free, got Up on the keyboard, held since "
              "line 4 (overlapping times)");
    EXPECT_EQ(step_error("release-key: Up"),
              "a.yaml:4:3: expected a control that is held, got Up on the keyboard, which is not");
}

TEST_F(KeyboardSteps, ReachTheUsbKeyboardAlone) {
    EXPECT_THAT(acts("press-key: {key: [Ctrl, c], to: usb}"),
                ElementsAre("USB key 0014 down", "USB key 0021 down", "wait 100ms",
                            "USB key 0021 up", "USB key 0014 up"));
    acts("type-keys: {text: H, to: usb}");
    board.wait(sim::SimTime{100'000'000'000});
    EXPECT_THAT(board.done, ElementsAre("wait 100ms", "USB key 0012 down", "USB key 0033 down",
                                        "USB key 0033 up", "USB key 0012 up"));
    EXPECT_EQ(said("hold-key: {key: Up, to: usb}"), "hold Up on the USB keyboard");
    EXPECT_EQ(said("type-keys: {text: a, to: usb}"), "type \"a\" on the USB keyboard");
    EXPECT_EQ(step_error("press-key: {key: a, to: hand}"),
              "a.yaml:4:27: expected usb, got \"hand\"");
}

TEST_F(KeyboardSteps, HoldAKeyOfEachKeyboardByItself) {
    const std::string head = "name: a\nversion: 1\nsteps:\n- hold-key: a\n- hold-key: ";
    EXPECT_EQ(error_of(head + "{key: a, to: usb}"), "no error");
}

TEST_F(KeyboardSteps, NeedAUsbKeyboardForUsb) {
    const std::string head = "name: a\nversion: 1\nps2: nothing\nusb: ";
    const std::string step = "\nsteps:\n- press-key: {key: a, to: usb}";
    EXPECT_EQ(error_of(head + "keyboard" + step), "no error");
    EXPECT_EQ(error_of(head + "[mouse, gamepad]" + step),
              "a.yaml:6:3: expected a keyboard in a USB port, got none");
}

TEST_F(KeyboardSteps, NeedAKeyboard) {
    const std::string head = "name: a\nversion: 1\nps2: mouse\nsteps:\n- ";
    for (const char* step : {"type-keys: a", "press-key: a", "hold-key: a"})
        EXPECT_EQ(error_of(head + step), "a.yaml:5:3: expected a keyboard among ps2, got none");
    EXPECT_EQ(error_of("name: a\nversion: 1\nps2: [nothing, keyboard]\nsteps:\n- press-key: a"),
              "no error");
}

}  // namespace
