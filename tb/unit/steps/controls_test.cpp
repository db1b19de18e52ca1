// controls_test.cpp - delay, press, hold, release
#include "sim/scenario/controls.h"
#include "tb/unit/steps/step_bench.h"

namespace {

using namespace tb;
using testing::ElementsAre;

class ControlSteps : public StepTest {};

TEST_F(ControlSteps, DelayWaits) {
    EXPECT_THAT(acts("delay: 500ms"), ElementsAre("wait 500ms"));
    EXPECT_EQ(said("delay: 1500us"), "wait 1.5ms");
}

TEST_F(ControlSteps, PressHolds100MillisecondsByDefault) {
    EXPECT_THAT(acts("press: {keypad: \"5\"}"),
                ElementsAre("hold keypad 5", "wait 100ms", "release keypad 5"));
    EXPECT_THAT(acts("press: {keypad: \"5\", for: 80ms}"),
                ElementsAre("hold keypad 5", "wait 80ms", "release keypad 5"));
}

TEST_F(ControlSteps, TakeEveryCapOfTheKeypad) {
    for (const char cap : std::string("123A456B789C0FED"))
        EXPECT_THAT(acts(std::string("hold: {keypad: \"") + cap + "\"}"),
                    ElementsAre(std::string("hold keypad ") + cap));
    EXPECT_THAT(acts("hold: {keypad: 7}"), ElementsAre("hold keypad 7"));
    EXPECT_THAT(
        acts("press: {switch: 7, bounce: 0ms}"),
        ElementsAre("hold switch 7 bounces 0s", "wait 100ms", "release switch 7 bounces 0s"));
}

TEST_F(ControlSteps, TakeListsOfEachKindOfControl) {
    EXPECT_THAT(acts("hold: {keypad: [\"1\", D, 5], key: [0, 3], switch: [9, 0]}"),
                ElementsAre("hold keypad 1 and 5 and D, key 0 and 3, switch 0 and 9"));
}

TEST_F(ControlSteps, TakeTheProcessorsKeyAmongTheOthers) {
    EXPECT_THAT(acts("press: {key: hps, for: 1s}"),
                ElementsAre("hold key hps", "wait 1s", "release key hps"));
    EXPECT_THAT(acts("hold: {key: [hps, 2]}"), ElementsAre("hold key 2 and hps"));
}

TEST_F(ControlSteps, ReleaseLetsGo) {
    const auto s = sim::parse_scenario(
        "name: a\nversion: 1\nsteps:\n- hold: {keypad: A, key: 1, switch: 2}\n"
        "- release: {keypad: A, switch: 2}\n",
        "a.yaml");
    s.steps.at(1).step->play(board);
    EXPECT_THAT(board.done, ElementsAre("release keypad A, switch 2"));
    EXPECT_EQ(s.steps[1].text, "release keypad A, switch 2");
}

TEST_F(ControlSteps, DescribeThemselves) {
    EXPECT_EQ(said("press: {keypad: [\"5\", \"1\"], key: 0}"),
              "press keypad 1 and 5, key 0 for 100ms");
    EXPECT_EQ(said("hold: {switch: [1, 2]}"), "hold switch 1 and 2");
}

TEST(Controls, NumberTheKeypadsCapsRowByRow) {
    const std::string caps = "123A456B789C0FED";
    for (unsigned n = 0; n < 16; ++n) EXPECT_EQ(sim::keypad_key(caps[n]), n);
    EXPECT_FALSE(sim::keypad_key('a'));
}

}  // namespace
