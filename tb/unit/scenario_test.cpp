// scenario_test.cpp - what a scenario file says, and the notations in it; its steps are in steps/
#include "sim/scenario/scenario.h"
#include "sim/scenario/seven_segment.h"

#include <gmock/gmock.h>

namespace {

using namespace sim;

constexpr std::uint64_t MS = 1'000'000'000;  // in ps

Scenario parse(const std::string& text) { return parse_scenario(text, "tests/run.yaml"); }

TEST(Scenario, HasANameASeedADurationAndSteps) {
    const auto s =
        parse("name: My run\nversion: 1\nseed: 42\nduration: 1.5s\nsteps: [{delay: 1ms}]");
    EXPECT_EQ(s.name, "My run");
    EXPECT_EQ(s.file, "tests/run.yaml");
    EXPECT_EQ(s.seed, 42u);
    EXPECT_EQ(s.duration->ps, 1500 * MS);
    EXPECT_EQ(s.steps.size(), 1u);
}

TEST(Scenario, HasSeedOneAndNoDurationByDefault) {
    const auto s = parse("name: a\nversion: 1\nsteps: [{delay: 1ms}]");
    EXPECT_EQ(s.seed, 1u);
    EXPECT_FALSE(s.duration);
    EXPECT_TRUE(s.project.empty());
    EXPECT_EQ(s.cpu, "");
    EXPECT_FALSE(s.memory_bridged);
    EXPECT_FALSE(s.audio_rate);
}

TEST(Scenario, DescribesTheChipAndTheRun) {
    const std::string head = "name: a\nversion: 1\nduration: 1s\n";
    EXPECT_EQ(parse(head + "project: b/c.qsf").project, "tests/b/c.qsf");
    EXPECT_EQ(parse(head + "cpu: native").cpu, "native");
    EXPECT_EQ(parse(head + "cpu: arm").cpu, "arm");
    EXPECT_EQ(parse(head + "fpga-memory: mapped").memory_bridged, false);
    EXPECT_EQ(parse(head + "fpga-memory: bridge").memory_bridged, true);
    EXPECT_EQ(parse(head + "audio-rate: 48000").audio_rate, 48'000u);
}

TEST(Scenario, TakesEverySeedOf64Bits) {
    EXPECT_EQ(parse("name: a\nversion: 1\nduration: 1s\nseed: 0").seed, 0u);
    EXPECT_EQ(parse("name: a\nversion: 1\nduration: 1s\nseed: 18446744073709551615").seed,
              18446744073709551615u);
    EXPECT_EQ(parse("name: a\nversion: 1\nduration: 1s\nseed: 0xFF").seed, 255u);
}

TEST(Scenario, DescribesWhatIsPluggedIntoThePs2Ports) {
    const auto ports = [](const std::string& line) {
        const Ps2Ports ps2 = parse("name: a\nversion: 1\nduration: 1s\n" + line).ps2;
        return std::pair{ps2.first, ps2.second};
    };
    EXPECT_EQ(ports(""), (std::pair{Ps2Plug::KEYBOARD, Ps2Plug::MOUSE}));
    EXPECT_EQ(ports("ps2: [mouse, keyboard]"), (std::pair{Ps2Plug::MOUSE, Ps2Plug::KEYBOARD}));
    EXPECT_EQ(ports("ps2: [nothing, mouse]"), (std::pair{Ps2Plug::NOTHING, Ps2Plug::MOUSE}));
    EXPECT_EQ(ports("ps2: mouse"), (std::pair{Ps2Plug::MOUSE, Ps2Plug::NOTHING}));
    EXPECT_EQ(ports("ps2: nothing"), (std::pair{Ps2Plug::NOTHING, Ps2Plug::NOTHING}));
}

TEST(Scenario, MayBeADurationAlone) {
    EXPECT_TRUE(parse("name: a\nversion: 1\nduration: 1s").steps.empty());
}

TEST(Scenario, KeepsTheOrderAndThePlaceOfItsSteps) {
    const auto s = parse("name: a\nversion: 1\nsteps:\n  - delay: 1ms\n\n  - press: {key: 0}\n");
    EXPECT_EQ(s.steps[0].line, 4);
    EXPECT_EQ(s.steps[1].line, 6);
    EXPECT_EQ(s.steps[1].column, 5);
    EXPECT_EQ(s.steps[1].text, "press key 0 for 100ms");
}

TEST(Scenario, AcceptsCrlfAndAByteOrderMark) {
    const auto s = parse(
        "\xEF\xBB\xBFname: a\r\nversion: 1\r\nsteps:\r\n  - delay: 1ms\r\n  - hold: {key: 2}\r\n");
    EXPECT_EQ(s.steps.at(1).line, 5);
    EXPECT_EQ(s.steps[1].text, "hold key 2");
}

// yaml-cpp 0.7 makes single bytes of these two escapes, which are no UTF-8.
TEST(Scenario, AcceptsEscapesOfNextLineAndNoBreakSpace) {
    const auto s = parse(R"(name: "caf\u00E9\N\_"
version: 1
duration: 1s)");
    EXPECT_EQ(s.name, "caf\xC3\xA9\xC2\x85\xC2\xA0");
}

TEST(SimTime, IsExactInEveryUnit) {
    EXPECT_EQ(SimTime::parse("1s")->ps, 1'000'000'000'000u);
    EXPECT_EQ(SimTime::parse("1.5s")->ps, 1'500'000'000'000u);
    EXPECT_EQ(SimTime::parse("500ms")->ps, 500'000'000'000u);
    EXPECT_EQ(SimTime::parse("20us")->ps, 20'000'000u);
    EXPECT_EQ(SimTime::parse("16ns")->ps, 16'000u);
    EXPECT_EQ(SimTime::parse("0.001ns")->ps, 1u);
    EXPECT_EQ(SimTime::parse("0.1000000000000000s")->ps, 100'000'000'000u);
    EXPECT_EQ(SimTime::parse("3599.999999999999s")->ps, 3'599'999'999'999'999u);
    EXPECT_EQ(SimTime::parse("3600s")->ps, MAX_SIM_TIME.ps);
    EXPECT_EQ(SimTime::parse("0ms")->ps, 0u);
}

TEST(SimTime, RefusesWhatIsNotATime) {
    for (const char* text : {"",
                             "1",
                             "s",
                             "ms",
                             "-1s",
                             "+1s",
                             "1 s",
                             " 1s",
                             "1s ",
                             "1.s",
                             ".5s",
                             "1,5s",
                             "1e3s",
                             "1m",
                             "2min",
                             "1S",
                             "1ss",
                             "0x1s",
                             "3600.1s",
                             "3601s",
                             "3600001ms",
                             "18446744073709551617ns",
                             "99999999999999999999999s",
                             "0.0001ns",
                             "1.0.0s",
                             "1s\n",
                             "\xC2\xB5s"})
        EXPECT_FALSE(SimTime::parse(text)) << '"' << text << '"';
}

TEST(SimTime, IsPrintedInTheLargestUnitThatFits) {
    for (const char* text : {"0s", "1s", "1.5s", "80ms", "20us", "16ns", "0.001ns", "3600s",
                             "59.999999999999s", "16.683333ms"})
        EXPECT_EQ(to_string(*SimTime::parse(text)), text);
}

std::string shown(std::uint8_t rightmost, const std::string& expected = "") {
    return hex_text({rightmost, 0x3F, 0x06, 0x5B, 0x4F, 0x00}, expected);
}

TEST(SevenSegment, ReadsEveryCharacterInEachOfItsForms) {
    for (const Glyph& glyph : GLYPHS) {
        const std::string text = std::string(" 3210") + glyph.character;
        EXPECT_TRUE(is_hex_text(text));
        EXPECT_EQ(shown(glyph.segments, text), text);
    }
}

TEST(SevenSegment, ReadsSixSevenAndNineWithAndWithoutTheirBars) {
    EXPECT_EQ(shown(0x7D), " 32106");
    EXPECT_EQ(shown(0x07), " 32107");
    EXPECT_EQ(shown(0x27), " 32107");
    EXPECT_EQ(shown(0x6F), " 32109");
    EXPECT_EQ(shown(0x67), " 32109");
}

TEST(SevenSegment, ReadsASixWithoutItsBarWhereExpected) {
    EXPECT_EQ(shown(0x7C, " 32106"), " 32106");
    EXPECT_EQ(shown(0x7C, " 3210B"), " 3210B");
    EXPECT_EQ(shown(0x7C, " 32108"), " 3210B");
    EXPECT_EQ(shown(0x7D, " 3210B"), " 32106");
}

TEST(SevenSegment, TakesSixCharactersThatItCanShow) {
    EXPECT_TRUE(is_hex_text("Error-"));
    EXPECT_FALSE(is_hex_text("12345"));
    EXPECT_FALSE(is_hex_text("1234567"));
    EXPECT_FALSE(is_hex_text("12345x"));
}

TEST(SevenSegment, ShowsAQuestionMarkForAnUnknownPattern) {
    EXPECT_EQ(hex_text({0x01, 0x3F, 0x3F, 0x3F, 0x3F, 0x3F}), "00000?");
}

}  // namespace
