// parts_test.cpp - parts: and the steps on them
#include "tb/unit/scenario_errors.h"
#include "tb/unit/steps/step_bench.h"

namespace {

using namespace tb;
using sim::PartPlan;
using testing::ElementsAre;

const std::string PARTS =
    "name: a\nversion: 1\nparts:\n"
    "- button: {name: fire, pin: \"GPIO_0[3]\"}\n"
    "- switch: {name: mode, pin: \"GPIO_0[4]\"}\n"
    "- led:\n    name: heart\n    pin: GPIO_1[35]\n    lit: low\n"
    "- led-matrix: {name: face, rows: \"GPIO_1[1:0]\", columns: \"GPIO_1[2:3], GPIO_0[9]\"}\n"
    "- keypad: GPIO_1[15:8]\n"
    "steps:\n- ";

class PartSteps : public StepTest {
protected:
    std::optional<sim::Verdict> play_with_parts(const std::string& step) {
        const sim::Scenario scenario = sim::parse_scenario(PARTS + step + "\n", "a.yaml");
        if (!hung_) board.hang(scenario.parts);
        hung_ = true;
        return scenario.steps.at(0).step->play(board);
    }
    std::string finds_with_parts(const std::string& step) {
        const auto verdict = play_with_parts(step);
        return verdict->met ? "met" : verdict->detail;
    }
    bool hung_ = false;
    static std::string error(const std::string& step) { return error_of(PARTS + step + "\n"); }
};

// The message about a list of parts, which begins in line 4.
std::string parts_error(const std::string& parts) {
    return error_of("name: a\nversion: 1\nparts:\n" + parts + "\nduration: 1s\n");
}

TEST_F(PartSteps, ReadPinsFromTheLeft) {
    const auto scenario = sim::parse_scenario(PARTS + "delay: 1s\n", "a.yaml");
    ASSERT_EQ(scenario.parts.size(), 5u);
    const PartPlan& matrix = scenario.parts[3];
    EXPECT_EQ(matrix.name, "face");
    EXPECT_THAT(matrix.pins, ElementsAre(37, 36, 38, 39, 9)) << "rows, then columns";
    EXPECT_EQ(matrix.rows, 2u);
    EXPECT_EQ(matrix.columns, 3u);
    EXPECT_THAT(scenario.parts[2].pins, ElementsAre(71));
    EXPECT_THAT(scenario.parts[4].pins, ElementsAre(51, 50, 49, 48, 47, 46, 45, 44));
}

TEST_F(PartSteps, KnowMatricesWhoseRowIsANumber) {
    const std::string matrices =
        "- led-matrix: {name: red, row-number: \"GPIO_1[9:8]\", columns: \"GPIO_1[1:0]\"}\n"
        "- led-matrix: {name: green, row-number: \"GPIO_1[9:8]\", columns: \"GPIO_1[3:2]\"}\n";
    const auto scenario = sim::parse_scenario(
        "name: a\nversion: 1\nparts:\n" + matrices +
            "steps:\n- expect-matrix: {matrix: red, equals: \"#.\\n.#\\n..\\n..\"}\n",
        "a.yaml");
    EXPECT_THAT(scenario.parts[1].shared, ElementsAre(45, 44));
    EXPECT_EQ(scenario.parts[1].rows, 4u);
}

TEST_F(PartSteps, RefuseMatricesWithTwoKindsOfRowsOrNone) {
    EXPECT_EQ(parts_error("- led-matrix: {name: a, columns: \"GPIO_1[1:0]\"}"),
              "a.yaml:4:3: expected rows or row-number in led-matrix, got none");
    EXPECT_EQ(parts_error("- led-matrix: {name: a, columns: \"GPIO_1[1:0]\", rows: "
                          "\"GPIO_1[3:2]\", row-number: \"GPIO_1[9:8]\"}"),
              "a.yaml:4:3: expected rows or row-number in led-matrix, got more than one of them");
}

TEST_F(PartSteps, MoveContacts) {
    play_with_parts("press-button: {button: fire, for: 80ms}");
    play_with_parts("press-button: fire");
    play_with_parts("hold-button: fire");
    play_with_parts("set-switch: {switch: mode, level: high}");
    play_with_parts("set-switch: {switch: mode, level: low}");
    EXPECT_THAT(board.done,
                ElementsAre("pins 8 0 0", "wait 80ms", "pins 8 0 2", "pins 8 0 0", "wait 100ms",
                            "pins 8 0 2", "pins 8 0 0", "pins 10 0 1", "pins 10 0 0"));
}

TEST_F(PartSteps, SitOnTheArduinoHeaderBesideOthers) {
    const auto scenario = sim::parse_scenario(
        "name: a\nversion: 1\nduration: 1s\nparts:\n"
        "  - led-matrix: {name: a, rows: \"ARDUINO_IO[1:0]\", columns: \"GPIO_1[2], "
        "ARDUINO_IO[15:14]\"}\n",
        "a.yaml");
    std::vector<std::string> names;
    for (const sim::HeaderPin pin : scenario.parts.at(0).pins) names.push_back(sim::pin_name(pin));
    EXPECT_THAT(names, ElementsAre("ARDUINO_IO[1]", "ARDUINO_IO[0]", "GPIO_1[2]", "ARDUINO_IO[15]",
                                   "ARDUINO_IO[14]"));
}

// Levels of GPIO_1; the LED on its pin 35 is lit by 0.
constexpr std::uint64_t HEART = std::uint64_t{1} << 35;

TEST_F(PartSteps, LookAtLeds) {
    play_with_parts("delay: 1ms");
    board.parts->look({0, 0}, board.now_ps());
    EXPECT_EQ(finds_with_parts("expect-led: {led: heart, equals: lit}"), "met");
    EXPECT_EQ(finds_with_parts("expect-led: {led: heart, equals: dark}"), "it is lit");
    board.meanwhile = [&] {
        if (board.now_ms() == 7) board.parts->look({0, HEART}, board.now_ps());
    };
    EXPECT_EQ(finds_with_parts("expect-led: {led: heart, equals: dark, timeout: 1s}"), "met");
    EXPECT_EQ(board.now_ms(), 7u);
}

// Its upper row is shown by GPIO_1[1]; a column is lit by 0: GPIO_1[2:3], GPIO_0[9].
TEST_F(PartSteps, LookAtAMatrix) {
    play_with_parts("delay: 1ms");
    board.parts->look({1 << 9, HEART | 0b1010}, board.now_ps());
    board.wait(sim::SimTime{1'000'000'000});
    EXPECT_EQ(finds_with_parts("expect-matrix: {matrix: face, equals: \"#..\\n...\"}"), "met");
    EXPECT_EQ(finds_with_parts("expect-matrix:\n    matrix: face\n    equals: |\n      #..\n"
                               "      ..#"),
              "face shows #../...");
}

TEST_F(PartSteps, SaveThePictureOfAnLt24) {
    const auto scenario = sim::parse_scenario(
        "name: a\nversion: 1\nparts:\n- lt24: GPIO_1\nsteps:\n"
        "- take-screenshot: {save-to: a.png, of: lt24}\n- take-screenshot: {save-to: b.png}\n",
        "a.yaml");
    board.hang(scenario.parts);
    for (const auto& step : scenario.steps) step.step->play(board);
    ASSERT_EQ(board.saved.size(), 2u);
    EXPECT_EQ(board.saved[0].second.width, 240u);
    EXPECT_EQ(board.saved[1].second.width, 640u);
    EXPECT_EQ(scenario.steps[0].text, "take screenshot a.png on lt24");
    EXPECT_EQ(step_error("take-screenshot: {save-to: a.png, of: lt24}"),
              "a.yaml:4:3: expected a display: monitor or HPS LCD, got \"lt24\"");
    EXPECT_EQ(parts_error("- lt24: GPIO_0\n- led: {name: a, pin: \"GPIO_0[13]\"}"),
              "a.yaml:5:3: expected pins that are free, got GPIO_0[13], which lt24 of line 4 has");
}

TEST_F(PartSteps, DescribeThemselves) {
    const auto steps =
        sim::parse_scenario(PARTS +
                                "press-button: fire\n- hold-button: fire\n"
                                "- release-button: fire\n"
                                "- set-switch: {switch: mode, level: high}\n"
                                "- expect-led: {led: heart, equals: lit, timeout: 1s}\n"
                                "- expect-matrix: {matrix: face, equals: \"#..\\n.+#\"}\n",
                            "a.yaml");
    std::vector<std::string> said;
    for (const auto& step : steps.steps) said.push_back(step.text);
    EXPECT_THAT(said, ElementsAre("press the button fire for 100ms", "hold the button fire",
                                  "release the button fire", "set the switch mode high",
                                  "expect the LED heart lit within 1s",
                                  "expect #../.+# on the matrix face"));
}

TEST_F(PartSteps, RefuseNamesThatAreNotThere) {
    EXPECT_EQ(error("press-button: fyre"),
              "a.yaml:13:3: expected a button of the parts: fire, got \"fyre\" (did you mean "
              "\"fire\"?)");
    EXPECT_EQ(error("expect-led: {led: fire, equals: lit}"),
              "a.yaml:13:3: expected an led of the parts: heart, got \"fire\"");
    EXPECT_EQ(step_error("hold-button: fire"),
              "a.yaml:4:3: expected a button among the parts, got \"fire\"");
    EXPECT_EQ(error("hold-button: fire\n- press-button: fire"),
              "a.yaml:14:3: expected a control that is free, got button fire, held since line 13 "
              "(overlapping times)");
    EXPECT_EQ(error("release-button: fire"),
              "a.yaml:13:3: expected a control that is held, got button fire, which is not");
}

TEST_F(PartSteps, RefuseAPictureOfAnotherSize) {
    EXPECT_EQ(error("expect-matrix: {matrix: face, equals: \"#..\"}"),
              "a.yaml:13:3: expected 2 rows of 3 characters, as face of line 10 has them, got 1 "
              "rows of 3");
    EXPECT_EQ(error("expect-matrix: {matrix: face, equals: \"#..\\n#.\"}"),
              "a.yaml:13:3: expected 2 rows of 3 characters, as face of line 10 has them, got 2 "
              "rows of 2");
}

TEST_F(PartSteps, RefuseWrongPins) {
    EXPECT_EQ(parts_error("- button: {name: a, pin: \"GPIO_0[36]\"}"),
              "a.yaml:4:26: expected a pin such as GPIO_0[3], numbered 0 to 35, got "
              "\"GPIO_0[36]\"");
    EXPECT_EQ(parts_error("- keypad: GPIO_1[6:0]"),
              "a.yaml:4:11: expected eight pins such as GPIO_1[7:0], numbered 0 to 35, got "
              "\"GPIO_1[6:0]\"");
    EXPECT_EQ(parts_error("- led: {name: a, pin: \"GPIO_0[3]\"}\n"
                          "- led: {name: b, pin: \"GPIO_0[3]\"}"),
              "a.yaml:5:3: expected pins that are free, got GPIO_0[3], which a of line 4 has");
    EXPECT_EQ(parts_error("- keypad: GPIO_1[3:0], GPIO_1[0:3]"),
              "a.yaml:4:3: expected pins that are free, got GPIO_1[0] twice");
}

TEST_F(PartSteps, RefuseWrongParts) {
    EXPECT_EQ(parts_error("- led: {name: a, pin: \"GPIO_0[3]\"}\n"
                          "- button: {name: a, pin: \"GPIO_0[4]\"}"),
              "a.yaml:5:3: expected a new name for each part, got \"a\" again, first in line 4");
    EXPECT_EQ(parts_error("- buton: {name: a}"),
              "a.yaml:4:3: expected a part, got \"buton\" (did you mean \"button\"?)");
    EXPECT_EQ(parts_error("- led: {pin: \"GPIO_0[3]\"}"),
              "a.yaml:4:3: expected \"name\" in led, got none");
    EXPECT_EQ(parts_error("- led: {name: 1a, pin: \"GPIO_0[3]\"}"),
              "a.yaml:4:15: expected a name of letters, digits, - and _, got \"1a\"");
}

}  // namespace
