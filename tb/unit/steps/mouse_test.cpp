// mouse_test.cpp - move-mouse, click-mouse, hold-mouse, release-mouse, drag-mouse, turn-wheel
#include "tb/unit/scenario_errors.h"
#include "tb/unit/steps/step_bench.h"

namespace {

using namespace tb;
using testing::ElementsAre;
using testing::StartsWith;

class MouseSteps : public StepTest {};

TEST_F(MouseSteps, MoveAtOneSpeedAndArriveExactly) {
    board.meanwhile = [&] {
        if (board.now_ms() == 51) {
            EXPECT_EQ(board.mouse_right, 150);
            EXPECT_EQ(board.mouse_up, 35);
        }
    };
    EXPECT_FALSE(play("move-mouse: {right: 300, down: -70}"));
    EXPECT_EQ(board.now_ms(), 100u);
    EXPECT_EQ(board.mouse_right, 300);
    EXPECT_EQ(board.mouse_up, 70);
    EXPECT_FALSE(play("move-mouse: {down: 5000, for: 1s}"));
    EXPECT_EQ(board.now_ms(), 1100u);
    EXPECT_EQ(board.mouse_up, -4930);
    EXPECT_EQ(said("move-mouse: {right: 5}"), "move the mouse 5 to the right and 0 down in 100ms");
}

TEST_F(MouseSteps, Click) {
    EXPECT_THAT(acts("click-mouse: left"),
                ElementsAre("button 0 down", "wait 100ms", "button 0 up"));
    EXPECT_THAT(acts("click-mouse: {button: right, for: 1s}"),
                ElementsAre("button 1 down", "wait 1s", "button 1 up"));
    EXPECT_EQ(said("click-mouse: left"), "press the left mouse button for 100ms");
}

TEST_F(MouseSteps, HoldAndRelease) {
    EXPECT_THAT(acts("hold-mouse: middle"), ElementsAre("button 2 down"));
    EXPECT_EQ(step_error("hold-mouse: left\n- click-mouse: left"),
              "a.yaml:5:3: expected a control that is free, got the left mouse button, held since "
              "line 4 (overlapping times)");
    EXPECT_EQ(step_error("hold-mouse: left\n- release-mouse: left\n- click-mouse: left"),
              "no error");
    EXPECT_EQ(step_error("release-mouse: left"),
              "a.yaml:4:3: expected a control that is held, got the left mouse button, which is "
              "not");
}

TEST_F(MouseSteps, DragWithTheButtonDownAllTheWay) {
    const auto done = acts("drag-mouse: {right: 20, down: 10, for: 2ms}");
    EXPECT_THAT(done, ElementsAre("button 0 down", "wait 30ms", "wait 1ms", "wait 1ms", "wait 30ms",
                                  "button 0 up"));
    EXPECT_EQ(board.mouse_right, 20);
    EXPECT_EQ(board.mouse_up, -10);
    EXPECT_EQ(said("drag-mouse: {right: 1, button: right}"),
              "drag the mouse 1 to the right and 0 down in 100ms with the right mouse button");
}

TEST_F(MouseSteps, TurnTheWheel) {
    EXPECT_THAT(acts("turn-wheel: 3"), ElementsAre("wheel 3"));
    EXPECT_THAT(acts("turn-wheel: -2"), ElementsAre("wheel -2"));
    EXPECT_EQ(said("turn-wheel: -2"), "turn the mouse wheel by 2 away from the hand");
}

TEST_F(MouseSteps, RefuseWhatNoHandDoes) {
    EXPECT_EQ(step_error("move-mouse: {}"),
              "a.yaml:4:3: expected right or down in move-mouse, got none");
    EXPECT_EQ(step_error("move-mouse: {right: 5001}"),
              "a.yaml:4:23: expected a distance from -5000 to 5000, got 5001");
    EXPECT_THAT(step_error("move-mouse: {right: -0}"), StartsWith("a.yaml:4:23: expected a dist"));
    EXPECT_THAT(step_error("turn-wheel: --1"), StartsWith("a.yaml:4:15: expected a number of no"));
    EXPECT_EQ(step_error("click-mouse: lef"),
              "a.yaml:4:16: expected left, right or middle, got \"lef\" (did you mean \"left\"?)");
}

TEST_F(MouseSteps, ReachTheUsbMouseAlone) {
    EXPECT_THAT(acts("move-mouse: {right: 4, down: 2, for: 2ms, to: usb}"),
                ElementsAre("wait 1ms", "USB mouse 2 -1", "wait 1ms", "USB mouse 2 -1"));
    EXPECT_THAT(acts("click-mouse: {button: right, to: usb}"),
                ElementsAre("USB button 1 down", "wait 100ms", "USB button 1 up"));
    EXPECT_THAT(acts("turn-wheel: {notches: -1, to: usb}"), ElementsAre("USB wheel -1"));
    EXPECT_EQ(board.mouse_right, 0);
    EXPECT_EQ(said("turn-wheel: {notches: 1, to: usb}"),
              "turn the USB mouse wheel by 1 towards the hand");
    EXPECT_EQ(said("hold-mouse: {button: left, to: usb}"), "hold the left USB mouse button");
    EXPECT_EQ(error_of("name: a\nversion: 1\nusb: keyboard\nsteps:\n"
                       "- drag-mouse: {right: 1, to: usb}"),
              "a.yaml:5:3: expected a mouse in a USB port, got none");
}

TEST_F(MouseSteps, NeedAMouse) {
    for (const char* step : {"move-mouse: {right: 1}", "click-mouse: left", "hold-mouse: left",
                             "drag-mouse: {right: 1}", "turn-wheel: 1"})
        EXPECT_EQ(error_of(std::string{"name: a\nversion: 1\nps2: keyboard\nsteps:\n- "} + step),
                  "a.yaml:5:3: expected a mouse among ps2, got none");
}

}  // namespace
