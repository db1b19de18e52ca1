// usb_test.cpp - plug-usb, unplug-usb
#include "tb/unit/scenario_errors.h"
#include "tb/unit/steps/step_bench.h"

namespace {

using namespace tb;

class UsbSteps : public StepTest {};

TEST_F(UsbSteps, PlugAndUnplug) {
    acts("unplug-usb: keyboard");
    EXPECT_FALSE(board.usb.keyboard.is_plugged());
    EXPECT_TRUE(board.usb.mouse.is_plugged());
    board.usb.gamepad.plug(false);
    acts("plug-usb: {device: gamepad}");
    EXPECT_TRUE(board.usb.gamepad.is_plugged());
    EXPECT_EQ(said("plug-usb: gamepad"), "plug in the USB gamepad");
    EXPECT_EQ(said("unplug-usb: mouse"), "unplug the USB mouse");
}

TEST_F(UsbSteps, RefuseWhatIsThereAlreadyOrNot) {
    EXPECT_EQ(step_error("plug-usb: mouse"),
              "a.yaml:4:3: expected a mouse that is in no USB port, got one that is in one");
    EXPECT_EQ(step_error("unplug-usb: gamepad"),
              "a.yaml:4:3: expected a gamepad in a USB port, got none");
    EXPECT_EQ(step_error("unplug-usb: mouse\n- unplug-usb: mouse"),
              "a.yaml:5:3: expected a mouse in a USB port, got none");
    EXPECT_EQ(step_error("plug-usb: gamepad\n- press-pad-button: A"), "no error");
    EXPECT_EQ(step_error("plug-usb: joystick"),
              "a.yaml:4:13: expected keyboard, mouse or gamepad, got \"joystick\"");
}

TEST_F(UsbSteps, FindInThePortsWhatTheScenarioSays) {
    const std::string head = "name: a\nversion: 1\nduration: 1s\n";
    const auto plugs = [&](const std::string& usb) {
        const sim::UsbPlugs found = sim::parse_scenario(head + usb, "a.yaml").usb;
        return fmt::format("{:d} {:d} {:d}", found.keyboard, found.mouse, found.gamepad);
    };
    EXPECT_EQ(plugs(""), "1 1 0");
    EXPECT_EQ(plugs("usb: nothing\n"), "0 0 0");
    EXPECT_EQ(plugs("usb: [gamepad, keyboard]\n"), "1 0 1");
    EXPECT_EQ(error_of(head + "usb: hub\n"),
              "a.yaml:4:6: expected keyboard, mouse, gamepad or nothing, got \"hub\"");
}

}  // namespace
