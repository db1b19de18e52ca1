// scenario_text_test.cpp - whatever bytes a scenario is made of, it ends in one printable line
#include <gmock/gmock.h>

#include <random>

#include "tb/unit/scenario_errors.h"

namespace {

using namespace sim;
using namespace tb;
using testing::EndsWith;
using testing::HasSubstr;
using testing::MatchesRegex;
using testing::Not;
using testing::StartsWith;

TEST(ScenarioError, RefusesWhatIsNotOneMap) {
    EXPECT_EQ(error_of(""), "a.yaml: expected a scenario, got an empty file");
    EXPECT_EQ(error_of("# nothing\n"), "a.yaml: expected a scenario, got an empty file");
    EXPECT_EQ(error_of("- a"),
              "a.yaml:1:1: expected a map with name, version and steps, got a list");
    EXPECT_EQ(error_of("hello"),
              "a.yaml:1:1: expected a map with name, version and steps, got \"hello\"");
    EXPECT_EQ(error_of("name: a\nversion: 1\nduration: 1s\n---\nname: b\n"),
              "a.yaml:5:1: expected one document, got a second");
}

TEST(ScenarioError, RefusesAnchorsAliasesTagsAndOddKeys) {
    EXPECT_EQ(error_of("name: &a b"), "a.yaml:1:7: expected a value written out, got an anchor");
    EXPECT_EQ(error_of("name: !!str b"),
              "a.yaml:1:7: expected a value without a tag, got the tag \"tag:yaml.org,2002:str\"");
    EXPECT_THAT(error_of("? [a]\n: b"), HasSubstr("expected a word as key, got a list"));
    // The classic: each line nine times the one above.  Stopped at the first anchor.
    std::string bomb = "a: &a [x,x,x,x,x,x,x,x,x]\n";
    for (char c = 'b'; c < 'k'; ++c) {
        bomb += std::string(1, c) + ": &" + c + " [";
        for (int i = 0; i < 9; ++i) bomb += std::string(i ? ",*" : "*") + static_cast<char>(c - 1);
        bomb += "]\n";
    }
    EXPECT_THAT(error_of(bomb), HasSubstr("got an anchor"));
}

TEST(ScenarioError, GivesThePlaceOfAMistakeInYaml) {
    EXPECT_THAT(error_of("name: a\nversion: [1\n"),
                MatchesRegex("a.yaml:[0-9]+:[0-9]+: expected YAML, got a mistake in it: .*"));
    EXPECT_THAT(error_of("name: \"a\\q\""),
                StartsWith("a.yaml:1:11: expected YAML, got a mistake"));
    EXPECT_THAT(error_of("name: *x"),
                StartsWith("a.yaml:1:7: expected YAML, got a mistake in it: "));
}

TEST(ScenarioError, RefusesBytesThatAreNotText) {
    EXPECT_EQ(error_of(std::string("name: a\nver\0sion", 15)),
              "a.yaml:2:4: expected text in UTF-8, got the byte 0x00");
    EXPECT_EQ(error_of("name: \xFF"), "a.yaml:1:7: expected text in UTF-8, got the byte 0xff");
    EXPECT_EQ(error_of("name: \xED\xA0\x80"),
              "a.yaml:1:7: expected text in UTF-8, got the byte 0xed");
    EXPECT_EQ(error_of("name: \xC0\x80"), "a.yaml:1:7: expected text in UTF-8, got the byte 0xc0");
}

TEST(ScenarioError, IsPrintableWhateverTheFileSays) {
    EXPECT_EQ(
        error_of("\"na\\e[2J\\nme\": a"),
        "a.yaml:1:1: expected a field of a scenario: name, version, seed, duration, "
        "program, project, board, cpu, fpga-memory, audio-rate, points, visibility, ps2, usb, "
        "parts or steps, "
        "got \"na\\x1b[2J\\x0ame\"");
    EXPECT_THAT(error_of("name: a\x1B[2J\nversion: 1\nduration: 1s"),
                EndsWith("expected a line of text, got \"a\\x1b[2J\""));
    EXPECT_THAT(error_of("\"\\x9b2J\": 1"), HasSubstr("got \"\\xc2\\x9b2J\""));
    EXPECT_THAT(error_of("name: a\nversion: " + std::string(5000, 'x')),
                EndsWith("got \"" + std::string(60, 'x') + "...\""));
}

TEST(ScenarioError, StopsAtDeepNestingOfEveryKind) {
    for (const char* open : {"[", "{a: ", "- ", "? ", "a:\n"}) {
        std::string text, indent;
        for (int i = 0; i < 10000; ++i) text += open;
        const std::string error = error_of(text);
        EXPECT_THAT(error, StartsWith("a.yaml:")) << open;
    }
    std::string steps = "name: a\nsteps: " + std::string(10000, '[') + std::string(10000, ']');
    EXPECT_THAT(error_of(steps), HasSubstr("expected at most 16 levels of lists and maps"));
}

TEST(ScenarioError, ComesSoonForAMebibyteOfAnything) {
    for (const char* part :
         {"[", "]", "{", "- ", "\"", "a", "? ", ": ", "#", "!", "&a ", "|\n", "a: b\n"}) {
        std::string text;
        while (text.size() + 8 < (1u << 20)) text += part;
        EXPECT_THAT(error_of(text), StartsWith("a.yaml:")) << part;
    }
}

TEST(ScenarioError, RefusesMoreThanAMebibyte) {
    EXPECT_EQ(error_of(std::string((1u << 20) + 1, '#')),
              "a.yaml: expected at most 1 MiB, got 1048577 bytes");
}

TEST(ScenarioFuzz, MutationsEndInAScenarioOrAnError) {
    const std::string good =
        "name: Everything  # a comment\nversion: 1\nseed: 7\nduration: 60s\nsteps:\n"
        "  - delay: 500ms\n  - press: {keypad: [\"1\", 'A'], key: [0, 1], for: 80ms}\n"
        "  - hold: {switch: 3}\n  - release: {switch: 3}\n  - wait-frame: {frame: 120, timeout: "
        "2s}\n"
        "  - wait-frame: next-swap\n  - wait-serial: |\n      ready\n  - expect-frame:\n"
        "      equals: golden.png\n      differing-pixels: 3\n"
        "  - expect-tone: {hz: 440, within: 3%, for: 100ms}\n  - expect-silence: {for: 1ms}\n"
        "  - expect-leds: \"0000000101\"\n  - expect-hex: {equals: \"   100\", timeout: 1s}\n"
        "  - take-screenshot: {save-to: a.png}\n";
    ASSERT_EQ(error_of(good), "no error");
    const std::string spice = "[]{}:,-?&*!|>'\"%@`#\\~ \n\t\r0159.aeE\x00\x1B\x7F\x80\xC3\xFF";
    std::mt19937 random(1);
    int refused = 0;
    for (int i = 0; i < 20000; ++i) {
        std::string text = good;
        for (unsigned edits = 1 + random() % 4; edits > 0; --edits) {
            const std::size_t at = random() % text.size(), size = random() % 20;
            switch (random() % 5) {
                case 0: text[at] = static_cast<char>(random()); break;
                case 1: text[at] = spice[random() % spice.size()]; break;
                case 2: text.insert(at, 1, spice[random() % spice.size()]); break;
                case 3: text.erase(at, size); break;
                case 4: text.insert(at, text.substr(random() % text.size(), size)); break;
            }
        }
        const std::string error = error_of(text);  // throws on, if it is no ScenarioError
        refused += error != "no error";
        ASSERT_THAT(error, Not(testing::ContainsRegex("[\x01-\x1F\x7F]"))) << text;
    }
    EXPECT_GT(refused, 10000);
    EXPECT_LT(refused, 20000);
}

}  // namespace
