// What a scenario asks of a board that has less than the DE1-SoC.
#include <string>

#include <gtest/gtest.h>

#include "sim/scenario/scenario.h"

namespace {

using sim::Scenario;

// Two KEYs, four LEDs, one digit, a header of two pins; no processor.
std::string refusal(const std::string& step, const std::string& more = "") {
    Scenario scenario =
        sim::parse_scenario("name: s\nversion: 1\n" + more + "steps:\n  - " + step, "s.yaml");
    sim::check_scenario(scenario);  // with all that there can be
    scenario.board = {"Little",
                      {"KEY[0]", "KEY[1]", "LEDR[0]", "LEDR[1]", "LEDR[2]", "LEDR[3]", "HEX0[0]",
                       "GPIO_0[0]", "GPIO_0[1]"}};
    try {
        sim::check_scenario(scenario);
    } catch (const sim::ScenarioError& error) {
        return error.message;
    }
    return "played";
}

TEST(ScenarioOnABoard, PlaysWhatTheBoardHas) {
    EXPECT_EQ(refusal("press: {key: 1}"), "played");
    EXPECT_EQ(refusal("expect-leds: \"0000001111\""), "played");
    EXPECT_EQ(refusal("expect-hex: \"     1\""), "played");
    EXPECT_EQ(refusal("expect-pins: {gpio_0: 1, level: high}"), "played");
    EXPECT_EQ(refusal("delay: 1ms"), "played");
}

TEST(ScenarioOnABoard, IsRefusedWithWhatTheBoardHas) {
    const std::string begin = "expected a step for what the Little has, got one for ";
    EXPECT_EQ(refusal("hold: {key: 2}"), begin + "key 2: it has 0 to 1");
    EXPECT_EQ(refusal("press: {key: hps}"), begin + "key hps, which it has not");
    EXPECT_EQ(refusal("expect-leds: 16"), begin + "LED 4: it has 0 to 3");
    EXPECT_EQ(refusal("expect-hps-led: lit"), begin + "the processor's LED, which it has not");
    EXPECT_EQ(refusal("press-key: a"), begin + "a PS/2 port, which it has not");
    EXPECT_EQ(refusal("set-voltage: {channel: 0, volts: 1}"),
              begin + "input 0 of the AD converter, which it has not");
    EXPECT_EQ(refusal("expect-silence: {for: 1s}"), begin + "LINE OUT, which it has not");
    EXPECT_EQ(refusal("tilt-board: {right: 9}"), begin + "the motion sensor, which it has not");
    EXPECT_EQ(refusal("wait-serial: a"), "played");
    EXPECT_EQ(refusal("set-pins: {gpio_0: 2, level: low}"),
              begin + "GPIO_0[2] of the headers: it has 0 to 1");
    EXPECT_EQ(refusal("delay: 1ms", "parts:\n  - button: {name: a, pin: \"GPIO_1[0]\"}\n"),
              "expected pins of the Little, got GPIO_1[0], which it has not");
    EXPECT_EQ(refusal("delay: 1ms", "parts:\n  - led: {name: a, pin: \"ARDUINO_IO[7]\"}\n"),
              "expected pins of the Little, got ARDUINO_IO[7], which it has not");
}

}  // namespace
