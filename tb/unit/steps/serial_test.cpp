// serial_test.cpp - type-serial, wait-serial
#include "tb/unit/scenario_errors.h"
#include "tb/unit/steps/step_bench.h"

namespace {

using namespace tb;
using testing::ElementsAre;

class SerialSteps : public StepTest {
protected:
    void print(const std::string& text) {
        for (const char c : text) board.seen.console(c);
    }
};

TEST_F(SerialSteps, TypeATextWithItsLineEnds) {
    EXPECT_THAT(acts("type-serial: \"ls\\n\""), ElementsAre("serial ls\n"));
    EXPECT_EQ(said("type-serial: \"ls\\n\""), "type \"ls\\x0a\"");
}

TEST_F(SerialSteps, TypeAtOneOfTheTerminals) {
    EXPECT_THAT(acts("type-serial: {text: ls, to: jtag-1}"), ElementsAre("to jtag-1 ls"));
    EXPECT_THAT(acts("type-serial: {text: ls, to: serial}"), ElementsAre("to serial ls"));
    EXPECT_THAT(acts("type-serial: {text: ls}"), ElementsAre("serial ls"));
    EXPECT_EQ(said("type-serial: {text: ls, to: jtag-0}"), "type \"ls\" at jtag-0");
}

TEST_F(SerialSteps, TypeAndReadAtATerminalOfTheParts) {
    const auto scenario = sim::parse_scenario(
        "name: a\nversion: 1\nparts:\n"
        "- terminal: {name: t, rx: \"GPIO_0[1]\", tx: \"GPIO_1[3]\", baud: 9600}\nsteps:\n"
        "- type-serial: {text: ls, to: t}\n- wait-serial: {text: ok, on: t, timeout: 5ms}\n",
        "a.yaml");
    EXPECT_THAT(scenario.parts[0].pins, ElementsAre(1, 39));
    for (const char c : std::string{"k ok k"}) board.terminals["t"].print(c);
    board.hang(scenario.parts);
    scenario.steps[0].step->play(board);
    board.wait(sim::SimTime{1'100'000'000});
    // GPIO_1[3] rises and falls by the bits of "l", 104 us each, then of "s".
    EXPECT_THAT(board.done, ElementsAre("wait 1.1ms", "pins 0 8 0", "pins 0 8 0", "pins 0 8 0",
                                        "pins 0 8 1", "pins 0 8 1", "pins 0 8 0", "pins 0 8 1",
                                        "pins 0 8 1", "pins 0 8 0", "pins 0 8 1", "pins 0 8 0"));
    EXPECT_TRUE(scenario.steps[1].step->play(board)->met);
    EXPECT_EQ(scenario.steps[1].step->play(board)->detail,
              "t received 2 characters after the last match, but not that: \" k\"");
    EXPECT_EQ(scenario.steps[1].text, "wait for \"ok\" on t within 5ms");
    EXPECT_EQ(step_error("type-serial: {text: a, to: t}"),
              "a.yaml:4:3: expected a terminal among the parts, got \"t\"");
}

TEST_F(SerialSteps, WaitUntilATextIsPrinted) {
    board.meanwhile = [&] {
        if (board.now_ms() == 30) print("ready\n");
    };
    EXPECT_EQ(finds("wait-serial: \"ready\\n\""), "met");
    EXPECT_EQ(board.now_ms(), 30u);
}

TEST_F(SerialSteps, LookAfterTheTextThatWasFoundBefore) {
    print("ready ready");
    EXPECT_EQ(finds("wait-serial: ready"), "met");
    EXPECT_EQ(finds("wait-serial: ready"), "met");
    EXPECT_EQ(finds("wait-serial: {text: ready, timeout: 1ms}"),
              "the console printed nothing after the last match");
}

TEST_F(SerialSteps, GiveUpAfterTenSecondsUnlessTheySaySo) {
    print("go!");
    EXPECT_EQ(finds("wait-serial: ready"),
              "the console printed 3 characters after the last match, but not that: \"go!\"");
    EXPECT_EQ(board.now_ms(), 10'000u);
    finds("wait-serial: {text: ready, timeout: 2s}");
    EXPECT_EQ(board.now_ms(), 12'000u);
}

TEST_F(SerialSteps, ReportTheEndOfWhatWasPrinted) {
    print(std::string(100, '-') + "\nEnter a number: ");
    EXPECT_EQ(finds("wait-serial: {text: ready, timeout: 1ms}"),
              "the console printed 117 characters after the last match, but not that: ...\"" +
                  std::string(43, '-') + "\\x0aEnter a number: \"");
}

TEST_F(SerialSteps, NeverPrintAControlCharacter) {
    EXPECT_EQ(said("wait-serial: ready"), "wait for \"ready\" on the serial line within 10s");
    EXPECT_EQ(said("wait-serial: \"a\\e[31m\\n\""),
              "wait for \"a\\x1b[31m\\x0a\" on the serial line within 10s");
}

}  // namespace
