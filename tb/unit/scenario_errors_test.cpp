// scenario_errors_test.cpp - every wrong field, value and step ends in one line with its place
#include <gmock/gmock.h>

#include "tb/unit/scenario_errors.h"

namespace {

using namespace sim;
using namespace tb;
using testing::EndsWith;
using testing::StartsWith;

TEST(ScenarioError, CarriesFilePlaceAndMessageApart) {
    try {
        parse_scenario("name: a\nversion: 2\nduration: 1s", "dir/a.yaml");
        FAIL();
    } catch (const ScenarioError& error) {
        EXPECT_EQ(error.file, "dir/a.yaml");
        EXPECT_EQ(error.line, 2);
        EXPECT_EQ(error.column, 10);
        EXPECT_STREQ(error.what(), ("dir/a.yaml:2:10: " + error.message).c_str());
    }
}

TEST(ScenarioError, NamesTheNearestFieldOfAFile) {
    EXPECT_EQ(error_of("nam: a"),
              "a.yaml:1:1: expected a field of a scenario, got \"nam\" (did you mean \"name\"?)");
    EXPECT_EQ(
        error_of("name: a\ncolour: red"),
        "a.yaml:2:1: expected a field of a scenario: name, version, seed, duration, "
        "program, project, board, cpu, fpga-memory, audio-rate, points, visibility, ps2, usb, "
        "parts or steps, "
        "got \"colour\"");
}

TEST(ScenarioError, NamesTheNearestStep) {
    EXPECT_EQ(step_error("pres: {key: 0}"),
              "a.yaml:4:3: expected a step, got \"pres\" (did you mean \"press\"?)");
    EXPECT_EQ(step_error("wait-frmae: 1"),
              "a.yaml:4:3: expected a step, got \"wait-frmae\" (did you mean \"wait-frame\"?)");
    EXPECT_EQ(step_error("hlod: {key: 0}"),
              "a.yaml:4:3: expected a step, got \"hlod\" (did you mean \"hold\"?)");
    EXPECT_THAT(step_error("jump: 1"),
                StartsWith("a.yaml:4:3: expected a step: show-picture, delay, press, "));
}

TEST(ScenarioError, NamesTheNearestFieldOfAStep) {
    EXPECT_EQ(step_error("press: {keypd: 0}"),
              "a.yaml:4:11: expected a field of press, got \"keypd\" (did you mean \"keypad\"?)");
}

TEST(ScenarioError, ReportsWhichFieldOfTheFileIsMissing) {
    EXPECT_EQ(error_of("version: 1\nduration: 1s"),
              "a.yaml:1:1: expected \"name\" in a scenario, got none");
    EXPECT_EQ(error_of("name: a\nduration: 1s"),
              "a.yaml:1:1: expected \"version\" in a scenario, got none");
    EXPECT_EQ(error_of("name: a\nversion: 1"),
              "a.yaml:1:1: expected \"steps\" or \"duration\" in a scenario, got none");
}

TEST(ScenarioError, ReportsWhatCanBeInAPs2Port) {
    const auto error = [](const std::string& ps2) {
        return error_of("name: a\nversion: 1\nduration: 1s\nps2: " + ps2);
    };
    EXPECT_EQ(error("mous"),
              "a.yaml:4:6: expected keyboard, mouse or nothing, got \"mous\" (did "
              "you mean \"mouse\"?)");
    EXPECT_EQ(error("[mouse, mouse]"),
              "a.yaml:4:14: expected each device once, got \"mouse\" again");
    EXPECT_EQ(error("[mouse, keyboard, nothing]"),
              "a.yaml:4:6: expected at most 2 in a list, got 3");
}

TEST(ScenarioError, ReportsWhichFieldOfAStepIsMissing) {
    EXPECT_EQ(step_error("expect-frame: {}"),
              "a.yaml:4:3: expected \"equals\" in expect-frame, got none");
    EXPECT_EQ(step_error("expect-tone: {within: 3%}"),
              "a.yaml:4:3: expected \"hz\" in expect-tone, got none");
    EXPECT_EQ(step_error("expect-silence: {}"),
              "a.yaml:4:3: expected \"for\" in expect-silence, got none");
    EXPECT_EQ(step_error("wait-serial: {timeout: 1s}"),
              "a.yaml:4:3: expected \"text\" in wait-serial, got none");
    EXPECT_EQ(step_error("take-screenshot: {}"),
              "a.yaml:4:3: expected \"save-to\" in take-screenshot, got none");
    EXPECT_EQ(step_error("press: {for: 1s}"),
              "a.yaml:4:3: expected keypad, key or switch in press, got none");
    EXPECT_EQ(step_error("hold: {}"),
              "a.yaml:4:3: expected keypad, key or switch in hold, got none");
    EXPECT_EQ(
        step_error("release:"),
        "a.yaml:4:3: expected a map with keypad, key, switch or bounce in release, got nothing");
}

TEST(ScenarioError, ReportsThatTheVersionMustBeOne) {
    EXPECT_EQ(error_of("name: a\nversion: 2\nduration: 1s"),
              "a.yaml:2:10: expected 1, the version of the format, got 2");
    EXPECT_EQ(
        error_of("name: a\nversion: \"1\"\nduration: 1s"),
        "a.yaml:2:10: expected 1, the version of the format, got \"1\" (leave out the quotes)");
}

struct BadValue {
    const char* step;
    int column;
    const char* message;  // from "expected" on
};

TEST(ScenarioError, ReportsWhatAValueShouldHaveBeen) {
    const char* const some_time =
        "expected a time above 0 such as 500ms (s, ms, us or ns, up to an hour), got ";
    const char* const time = "expected a time such as 500ms (s, ms, us or ns, up to an hour), got ";
    const BadValue cases[] = {
        {"delay: 500", 10, time},
        {"delay: -1s", 10, time},
        {"delay: 3601s", 10, time},
        {"delay: {time: 1s}", 10, time},
        {"delay:", 3, time},
        {"press: {key: 0, for: 0s}", 24, some_time},
        {"press: {keypad: G}", 19, "expected a keypad key, 0-9 or A-F, got \"G\""},
        {"press: {keypad: a}", 19, "expected a keypad key, 0-9 or A-F, got \"a\""},
        {"press: {keypad: \"12\"}", 19, "expected a keypad key, 0-9 or A-F, got \"12\""},
        {"press: {keypad: \"\"}", 19, "expected a keypad key, 0-9 or A-F, got \"\""},
        {"press: {keypad: [\"1\", \"X\"]}", 25, "expected a keypad key, 0-9 or A-F, got \"X\""},
        {"press: {keypad: [\"1\", 1]}", 25, "expected each control once, got 1 again"},
        {"press: {keypad: []}", 19, "expected a keypad key, 0-9 or A-F, got an empty list"},
        {"press: {keypad: [[1]]}", 20, "expected a keypad key, 0-9 or A-F, got a list"},
        {"press: {key: 4}", 16, "expected a key number, 0 to 3, or hps, got 4"},
        {"press: {key: -1}", 16, "expected a key number, 0 to 3, or hps, got -1"},
        {"press: {key: \"1\"}", 16,
         "expected a key number, 0 to 3, or hps, got \"1\" (leave out the quotes)"},
        {"press: {switch: 10}", 19, "expected a switch number, 0 to 9, got 10"},
        {"press: {switch: 1.5}", 19, "expected a switch number, 0 to 9, got 1.5"},
        {"press: 5", 10, "expected a map with keypad, key, switch, bounce or for in press, got 5"},
        {"wait-frame: 0", 15,
         "expected a frame number from 1 to 1000000, next or next-swap, got 0"},
        {"wait-frame: nxt", 15,
         "expected a frame number from 1 to 1000000, next or next-swap, got \"nxt\" (did you mean "
         "\"next\"?)"},
        {"wait-frame: {frame: 1, timeout: 0s}", 35, some_time},
        {"wait-serial: \"\"", 16, "expected text, got \"\""},
        {"wait-serial: 42", 16, "expected text, got 42 (put it in quotes)"},
        {"wait-serial: yes", 16, "expected text, got yes (put it in quotes)"},
        {"wait-serial: [a]", 16, "expected text, got a list"},
        {"expect-frame: a.png", 17,
         "expected a map with equals, differing-pixels, ignore or of in expect-frame, got "
         "\"a.png\""},
        {"expect-frame: {equals: 5}", 26, "expected a file's name, got 5 (put it in quotes)"},
        {"expect-frame: {equals: .}", 26, "expected a file's name, got \".\""},
        {"play-file: a/", 14, "expected a file's name, got \"a/\""},
        {"expect-frame: {equals: a, differing-pixels: 1310721}", 47,
         "expected a whole number from 0 to 1310720, got 1310721"},
        {"expect-tone: {hz: 19}", 21, "expected a frequency in hertz, 20 to 20000, got 19"},
        {"expect-tone: {hz: 440Hz}", 21,
         "expected a frequency in hertz, 20 to 20000, got \"440Hz\""},
        {"expect-tone: {hz: .nan}", 21, "expected a frequency in hertz, 20 to 20000, got .nan"},
        {"expect-tone: {hz: 440, within: 0%}", 34, "expected a percentage such as 3%, "},
        {"expect-tone: {hz: 440, within: 51%}", 34, "expected a percentage such as 3%, "},
        {"expect-tone: {hz: 440, within: 3}", 34, "expected a percentage such as 3%, "},
        {"expect-leds: 1024", 16, "expected ten characters 0 or 1, LEDR9 first, or a number from "},
        {"expect-leds: \"101\"", 16, "expected ten characters 0 or 1, LEDR9 first, or a number "},
        {"expect-leds: \"000000010x\"", 16, "expected ten characters 0 or 1, LEDR9 first, or a "},
        {"expect-hex: \"12345\"", 15, "expected six characters, HEX5 first, "},
        {"expect-hex: \"12345K\"", 15, "expected six characters, HEX5 first, "},
        {"take-screenshot: {save-to: /a.png}", 30, "expected a name such as start.png inside the "},
        {"take-screenshot: {save-to: ../a.png}", 30,
         "expected a name such as start.png inside the "},
        {"take-screenshot: {save-to: a/../../b.png}", 30, "expected a name such as start.png "},
        {"take-screenshot: {save-to: a.jpg}", 30, "expected a name such as start.png inside the "},
        {"take-screenshot: {save-to: \"a\\n.png\"}", 30, "expected a name such as start.png "},
    };
    for (const auto& c : cases)
        EXPECT_THAT(step_error(c.step),
                    StartsWith("a.yaml:4:" + std::to_string(c.column) + ": " + c.message))
            << c.step;
}

TEST(ScenarioError, AsksForQuotesAroundDigits) {
    EXPECT_THAT(step_error("expect-leds: 0000000101"),
                EndsWith("got 0000000101 (put it in quotes)"));
    EXPECT_THAT(step_error("expect-hex: 123456"), EndsWith("got 123456 (put it in quotes)"));
}

TEST(ScenarioError, NamesTheSecondOfTwoEqualKeys) {
    EXPECT_EQ(error_of("name: a\nversion: 1\nname: b"),
              "a.yaml:3:1: expected each key once, got \"name\" again, first in line 1");
    EXPECT_EQ(step_error("press: {key: 0, key: 1}"),
              "a.yaml:4:19: expected each key once, got \"key\" again, first in line 4");
}

TEST(ScenarioError, ReportsThatAnItemOfTheListIsOneStep) {
    EXPECT_EQ(step_error("delay: 1s\n  press: {key: 0}"),
              "a.yaml:5:3: expected one step in an item of the list, got \"press\" after \"delay\" "
              "(is it to be indented?)");
    EXPECT_EQ(step_error("delay"),
              "a.yaml:4:3: expected a step such as `delay: 500ms`, got \"delay\"");
    EXPECT_EQ(error_of("name: a\nversion: 1\nsteps: [{}]"),
              "a.yaml:3:9: expected a step such as `delay: 500ms`, got an empty map");
    EXPECT_EQ(error_of("name: a\nversion: 1\nsteps: []"),
              "a.yaml:3:8: expected one step or more, got an empty list");
    EXPECT_EQ(error_of("name: a\nversion: 1\nsteps: {delay: 1s}"),
              "a.yaml:3:8: expected a list of steps, got a map");
}

TEST(ScenarioError, NamesTheLineSinceWhichAControlIsHeld) {
    const std::string hold = "hold: {keypad: [\"5\", \"6\"]}\n- ";
    EXPECT_EQ(step_error(hold + "delay: 1s\n- hold: {keypad: \"6\"}"),
              "a.yaml:6:3: expected a control that is free, got keypad 6, held since line 4 "
              "(overlapping times)");
    EXPECT_EQ(step_error(hold + "press: {keypad: \"5\"}"),
              "a.yaml:5:3: expected a control that is free, got keypad 5, held since line 4 "
              "(overlapping times)");
    EXPECT_EQ(step_error(hold + "release: {key: 3}"),
              "a.yaml:5:3: expected a control that is held, got key 3, which is not");
    EXPECT_EQ(step_error(hold + "release: {keypad: \"5\"}\n- release: {keypad: \"5\"}"),
              "a.yaml:6:3: expected a control that is held, got keypad 5, which is not");
    EXPECT_EQ(step_error(hold + "release: {keypad: \"5\"}\n- press: {keypad: \"5\", switch: 5}"),
              "no error");
}

TEST(ScenarioError, NamesTheFirstStepBeyondTheDuration) {
    const std::string head = "name: a\nversion: 1\nduration: 1s\nsteps:\n- delay: 900ms\n";
    EXPECT_EQ(error_of(head + "- press: {key: 0}\n- wait-frame: next\n"), "no error");
    EXPECT_EQ(error_of(head + "- press: {key: 0, for: 101ms}\n- expect-leds: 1\n- delay: 5s"),
              "a.yaml:7:3: expected steps that fit into the duration of 1s, got \"expect LEDs "
              "0000000001\", which can not begin before 1.001s");
    EXPECT_EQ(
        error_of(head + "- expect-silence: {for: 200ms}"),
        "a.yaml:6:3: expected steps that fit into the duration of 1s, got \"expect silence for "
        "200ms\", which can not end before 1.1s");
}

TEST(ScenarioError, RefusesTwoScreenshotsOfOneName) {
    EXPECT_EQ(
        step_error("take-screenshot: {save-to: a.png}\n- take-screenshot: {save-to: ./a.png}"),
        "a.yaml:5:3: expected a new file name, got \"./a.png\" again, first in line 4");
}

TEST(ScenarioError, RefusesAScreenshotBelowAnother) {
    EXPECT_EQ(
        step_error("take-screenshot: {save-to: a.png}\n- take-screenshot: {save-to: a.png/b.png}"),
        "a.yaml:5:3: expected a new file name, got \"a.png/b.png\" below \"a.png\" of line 4");
    EXPECT_EQ(
        step_error("take-screenshot: {save-to: a.png/b.png}\n- take-screenshot: {save-to: a.png}"),
        "a.yaml:5:3: expected a new file name, got \"a.png\" above \"a.png/b.png\" of line 4");
}

TEST(ScenarioError, RefusesAScreenshotOverAFileOfTheRun) {
    for (const std::string name :
         {"junit.xml/x.png", "./report.json/x.png", "console.txt//a/x.png", "audio.wav/x.png",
          "audio-2.wav/x.png", "report.json.part/x.png", "frames/frame_000001.png", "frames/x.png",
          "mismatch/line4_a_actual.png"})
        EXPECT_EQ(
            step_error("delay: 1ms\n- take-screenshot: {save-to: " + name + "}"),
            "a.yaml:5:3: expected a file that the run does not write itself, got \"" + name + "\"");
    for (const std::string name : {"frames.png", "shots/frames/x.png", "report.json.png",
                                   "shots/report.json/x.png", "audio-x.wav/x.png"})
        EXPECT_EQ(step_error("take-screenshot: {save-to: " + name + "}"), "no error");
}

}  // namespace
