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
    acts("plug-usb: {device: gamepad}");
    EXPECT_TRUE(board.usb.gamepads[0].is_plugged());
    EXPECT_EQ(said("plug-usb: gamepad"), "plug in the USB gamepad");
    EXPECT_EQ(said("unplug-usb: mouse"), "unplug the USB mouse");
}

TEST_F(UsbSteps, GiveAGamepadTheLowestNumberThatIsFree) {
    const auto scenario = sim::parse_scenario(
        "name: a\nversion: 1\nsteps:\n- plug-usb: gamepad\n- plug-usb: snes-gamepad\n"
        "- unplug-usb: gamepad\n- plug-usb: snes-gamepad\n"
        "- unplug-usb: {device: snes-gamepad, pad: 2}\n- plug-usb: {device: gamepad, pad: 2}\n",
        "a.yaml");
    std::string numbers;
    for (const sim::ScenarioStep& step : scenario.steps) {
        step.step->play(board);
        for (const sim::UsbPlugged& one : board.usb.plugged().gamepads())
            numbers +=
                fmt::format("{}{}", one.plug == sim::UsbPlug::GAMEPAD ? "g" : "s", one.number);
        numbers += " ";
    }
    EXPECT_EQ(numbers, "g1 g1s2 s2 s1s2 s1 s1g2 ");
    EXPECT_EQ(scenario.steps[4].text, "unplug the USB snes-gamepad, pad 2");
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
              "a.yaml:4:13: expected keyboard, mouse, gamepad or snes-gamepad, got \"joystick\"");
}

TEST_F(UsbSteps, RefuseAGamepadThatHasNoPlaceOrIsNotMeantAlone) {
    EXPECT_EQ(step_error("plug-usb: gamepad\n- plug-usb: snes-gamepad\n- plug-usb: gamepad"),
              "a.yaml:6:3: expected a gamepad less in the USB ports, got two that are in them");
    EXPECT_EQ(step_error("plug-usb: gamepad\n- plug-usb: {device: gamepad, pad: 1}"),
              "a.yaml:5:3: expected pad: 2, which is free, got pad: 1");
    EXPECT_EQ(step_error("plug-usb: gamepad\n- plug-usb: gamepad\n- unplug-usb: gamepad"),
              "a.yaml:6:3: expected pad: 1 or pad: 2 in the step, as two of them are in USB ports, "
              "got neither");
    EXPECT_EQ(step_error("plug-usb: gamepad\n- unplug-usb: {device: gamepad, pad: 2}"),
              "a.yaml:5:3: expected a gamepad in a USB port: pad: 1, got pad: 2");
    EXPECT_EQ(step_error("unplug-usb: {device: mouse, pad: 1}"),
              "a.yaml:4:3: expected a gamepad with pad: 1, got a mouse");
}

TEST_F(UsbSteps, FindInThePortsWhatTheScenarioSays) {
    const std::string head = "name: a\nversion: 1\nduration: 1s\n";
    const auto plugs = [&](const std::string& usb) {
        std::string found;
        for (const sim::UsbPlugged& one : sim::parse_scenario(head + usb, "a.yaml").usb.all)
            found += fmt::format("{}{} ", "kmgs"[static_cast<std::size_t>(one.plug)], one.number);
        return found;
    };
    EXPECT_EQ(plugs(""), "k0 m0 ");
    EXPECT_EQ(plugs("usb: nothing\n"), "");
    EXPECT_EQ(plugs("usb: [gamepad, keyboard]\n"), "g1 k0 ");
    EXPECT_EQ(plugs("usb: [mouse, snes-gamepad, keyboard, gamepad]\n"), "m0 s1 k0 g2 ");
    EXPECT_EQ(plugs("usb: [gamepad, gamepad]\n"), "g1 g2 ");
    EXPECT_EQ(error_of(head + "usb: hub\n"),
              "a.yaml:4:6: expected keyboard, mouse, gamepad, snes-gamepad or nothing, got "
              "\"hub\"");
    EXPECT_EQ(error_of(head + "usb: [gamepad, snes-gamepad, gamepad]\n"),
              "a.yaml:4:30: expected at most two gamepads in a list, got one more");
    EXPECT_EQ(error_of(head + "usb: [mouse, mouse]\n"),
              "a.yaml:4:14: expected each device once, got \"mouse\" again");
}

}  // namespace
