// scenario_test.cpp - what each step of a scenario file means
#include "sim/scenario/scenario.h"
#include "sim/scenario/seven_segment.h"

#include <gmock/gmock.h>

namespace {

using namespace sim;

constexpr std::uint64_t MS = 1'000'000'000;  // in ps

Scenario parse(const std::string& text) { return parse_scenario(text, "tests/run.yaml"); }

// The only step of a scenario, written as it stands behind "- ".
Step step(const std::string& text) {
    return parse("name: a\nversion: 1\nsteps:\n  - " + text + "\n").steps.at(0);
}

template <class Action>
Action action(const std::string& text) {
    return std::get<Action>(step(text).action);
}

TEST(Scenario, HasANameASeedADurationAndSteps) {
    const auto s =
        parse("name: My run\nversion: 1\nseed: 42\nduration: 1.5s\nsteps: [{delay: 1ms}]");
    EXPECT_EQ(s.name, "My run");
    EXPECT_EQ(s.file, "tests/run.yaml");
    EXPECT_EQ(s.seed, 42u);
    EXPECT_EQ(s.duration->ps, 1500 * MS);
    EXPECT_EQ(s.steps.size(), 1u);
}

TEST(Scenario, HasSeedOneAndNoDurationUnlessItSaysSo) {
    const auto s = parse("name: a\nversion: 1\nsteps: [{delay: 1ms}]");
    EXPECT_EQ(s.seed, 1u);
    EXPECT_FALSE(s.duration);
}

TEST(Scenario, TakesEverySeedOf64Bits) {
    EXPECT_EQ(parse("name: a\nversion: 1\nduration: 1s\nseed: 0").seed, 0u);
    EXPECT_EQ(parse("name: a\nversion: 1\nduration: 1s\nseed: 18446744073709551615").seed,
              18446744073709551615u);
    EXPECT_EQ(parse("name: a\nversion: 1\nduration: 1s\nseed: 0xFF").seed, 255u);
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

TEST(Scenario, IsReadTheSameWithWindowsLineEndsAndAByteOrderMark) {
    const auto s = parse(
        "\xEF\xBB\xBFname: a\r\nversion: 1\r\nsteps:\r\n  - delay: 1ms\r\n  - hold: {key: 2}\r\n");
    EXPECT_EQ(s.steps.at(1).line, 5);
    EXPECT_EQ(std::get<Hold>(s.steps[1].action).controls.keys, 4);
}

TEST(Delay, TakesATime) { EXPECT_EQ(action<Delay>("delay: 500ms").time.ps, 500 * MS); }

TEST(Press, MapsTheKeypadsCapsRowByRow) {
    const std::string caps = "123A456B789C0FED";
    for (unsigned n = 0; n < 16; ++n)
        EXPECT_EQ(
            action<Press>(std::string("press: {keypad: \"") + caps[n] + "\"}").controls.keypad,
            1u << n)
            << caps[n];
}

TEST(Press, LastsATenthOfASecondUnlessItSaysSo) {
    EXPECT_EQ(action<Press>("press: {keypad: \"5\"}").time.ps, 100 * MS);
    EXPECT_EQ(action<Press>("press: {keypad: \"5\", for: 80ms}").time.ps, 80 * MS);
}

TEST(Press, TakesListsOfEachKindOfControl) {
    const auto press = action<Press>("press: {keypad: [\"1\", D, 5], key: [0, 3], switch: [9, 0]}");
    EXPECT_EQ(press.controls, (Controls{1u | 1u << 15 | 1u << 5, 0b1001, 0b1000000001}));
}

TEST(Press, TakesADigitOfTheKeypadWithoutQuotes) {
    EXPECT_EQ(action<Press>("press: {keypad: 7}").controls.keypad, 1u << 8);
}

TEST(HoldAndRelease, TakeTheSameControls) {
    const auto s = parse(
        "name: a\nversion: 1\nsteps:\n- hold: {keypad: A, key: 1, switch: 2}\n"
        "- release: {keypad: A, switch: 2}\n");
    EXPECT_EQ(std::get<Hold>(s.steps[0].action).controls, (Controls{8, 2, 4}));
    EXPECT_EQ(std::get<Release>(s.steps[1].action).controls, (Controls{8, 0, 4}));
}

TEST(WaitFrame, TakesANumberNextOrNextSwap) {
    EXPECT_EQ(action<WaitFrame>("wait-frame: 120").what, WaitFrame::What::NUMBER);
    EXPECT_EQ(action<WaitFrame>("wait-frame: 120").number, 120u);
    EXPECT_EQ(action<WaitFrame>("wait-frame: next").what, WaitFrame::What::NEXT);
    EXPECT_EQ(action<WaitFrame>("wait-frame: next-swap").what, WaitFrame::What::NEXT_SWAP);
    EXPECT_EQ(action<WaitFrame>("wait-frame: {frame: next-swap}").what, WaitFrame::What::NEXT_SWAP);
}

TEST(WaitFrame, GivesUpAfterTenSecondsUnlessItSaysSo) {
    EXPECT_EQ(action<WaitFrame>("wait-frame: next").timeout.ps, 10'000 * MS);
    EXPECT_EQ(action<WaitFrame>("wait-frame: {frame: 3}").timeout.ps, 10'000 * MS);
    EXPECT_EQ(action<WaitFrame>("wait-frame: {frame: 3, timeout: 2s}").timeout.ps, 2'000 * MS);
}

TEST(WaitSerial, TakesATextAndATimeout) {
    EXPECT_EQ(action<WaitSerial>("wait-serial: \"ready\\n\"").text, "ready\n");
    EXPECT_EQ(action<WaitSerial>("wait-serial: ready").timeout.ps, 10'000 * MS);
    const auto wait = action<WaitSerial>("wait-serial: {text: go, timeout: 2s}");
    EXPECT_EQ(wait.text, "go");
    EXPECT_EQ(wait.timeout.ps, 2'000 * MS);
}

TEST(ExpectFrame, FindsTheGoldenPictureBesideTheScenario) {
    const auto expect = action<ExpectFrame>("expect-frame: {equals: golden.png}");
    EXPECT_EQ(expect.golden, "tests/golden.png");
    EXPECT_EQ(expect.differing_pixels, 0u);
}

TEST(ExpectFrame, MayLetPixelsDiffer) {
    const auto expect = action<ExpectFrame>("expect-frame: {equals: a.png, differing-pixels: 12}");
    EXPECT_EQ(expect.differing_pixels, 12u);
}

TEST(ExpectTone, HasDefaultsForAllButTheFrequency) {
    const auto tone = action<ExpectTone>("expect-tone: {hz: 440}");
    EXPECT_EQ(tone.hz, 440);
    EXPECT_DOUBLE_EQ(tone.within, 0.03);
    EXPECT_EQ(tone.time.ps, 100 * MS);
    EXPECT_EQ(tone.timeout.ps, 1'000 * MS);
}

TEST(ExpectTone, TakesAllItsFields) {
    const auto tone =
        action<ExpectTone>("expect-tone: {hz: 440.5, within: 0.5%, for: 50ms, timeout: 0s}");
    EXPECT_EQ(tone.hz, 440.5);
    EXPECT_DOUBLE_EQ(tone.within, 0.005);
    EXPECT_EQ(tone.time.ps, 50 * MS);
    EXPECT_EQ(tone.timeout.ps, 0u);
}

TEST(ExpectSilence, TakesATime) {
    EXPECT_EQ(action<ExpectSilence>("expect-silence: {for: 100ms}").time.ps, 100 * MS);
}

TEST(ExpectLeds, TakesAPatternOrANumberNowOrWithinATime) {
    EXPECT_EQ(action<ExpectLeds>("expect-leds: \"0000000101\"").leds, 5);
    EXPECT_EQ(action<ExpectLeds>("expect-leds: \"1000000000\"").leds, 512);
    EXPECT_EQ(action<ExpectLeds>("expect-leds: 1023").leds, 1023);
    EXPECT_EQ(action<ExpectLeds>("expect-leds: 0").timeout.ps, 0u);
    EXPECT_EQ(action<ExpectLeds>("expect-leds: {equals: 3}").timeout.ps, 0u);
    EXPECT_EQ(action<ExpectLeds>("expect-leds: {equals: 3, timeout: 1s}").timeout.ps, 1'000 * MS);
}

TEST(ExpectHex, TakesSixCharactersLeftmostFirst) {
    const auto hex = action<ExpectHex>("expect-hex: \"   100\"");
    EXPECT_EQ(hex.text, "   100");
    EXPECT_EQ(hex.timeout.ps, 0u);
    EXPECT_EQ(action<ExpectHex>("expect-hex: {equals: Error-, timeout: 1s}").timeout.ps,
              1'000 * MS);
}

TEST(TakeScreenshot, TakesANameInTheOutputFolder) {
    EXPECT_EQ(action<TakeScreenshot>("take-screenshot: {save-to: a.png}").save_to, "a.png");
    EXPECT_EQ(action<TakeScreenshot>("take-screenshot: {save-to: shots/a.b.png}").save_to,
              "shots/a.b.png");
}

TEST(SetVoltage, TakesAChannelAndVolts) {
    const auto set = action<SetVoltage>("set-voltage: {channel: 7, volts: 1.25}");
    EXPECT_EQ(set.channel, 7u);
    EXPECT_EQ(set.volts, 1.25);
}

TEST(SetVoltage, SaysWhatItApplies) {
    EXPECT_EQ(step("set-voltage: {channel: 0, volts: 3}").text, "apply 3 V to CH0");
}

TEST(TypeSerial, TakesATextWithItsLineEnds) {
    EXPECT_EQ(action<TypeSerial>("type-serial: \"ls\\n\"").text, "ls\n");
}

TEST(TypeKeys, TakesWhatAKeyboardHas) {
    EXPECT_EQ(action<TypeKeys>("type-keys: \"Hi!\\n\"").text, "Hi!\n");
}

TEST(SayStep, SoundsLikeAPerson) {
    EXPECT_EQ(step("type-keys: 'Hi!'").text, "type \"Hi!\" on the keyboard");
    EXPECT_EQ(step("type-serial: \"ls\\n\"").text, "type \"ls\\x0a\"");
    EXPECT_EQ(step("delay: 1500us").text, "wait 1.5ms");
    EXPECT_EQ(step("press: {keypad: [\"5\", \"1\"], key: 0}").text,
              "press keypad 1 and 5, key 0 for 100ms");
    EXPECT_EQ(step("hold: {switch: [1, 2]}").text, "hold switch 1 and 2");
    EXPECT_EQ(step("wait-frame: 120").text, "wait for frame 120 within 10s");
    EXPECT_EQ(step("wait-frame: {frame: next, timeout: 1s}").text,
              "wait for the next frame within 1s");
    EXPECT_EQ(step("wait-frame: next-swap").text, "wait for the next new picture within 10s");
    EXPECT_EQ(step("wait-serial: ready").text, "wait for \"ready\" on the serial line within 10s");
    EXPECT_EQ(step("expect-frame: {equals: a/b.png, differing-pixels: 3}").text,
              "expect the picture b.png but for 3 pixels");
    EXPECT_EQ(step("expect-tone: {hz: 440}").text,
              "expect a tone of 440 Hz, give or take 3%, for 100ms within 1s");
    EXPECT_EQ(step("expect-silence: {for: 1s}").text, "expect silence for 1s");
    EXPECT_EQ(step("expect-leds: 5").text, "expect LEDs 0000000101");
    EXPECT_EQ(step("expect-hex: {equals: \"   100\", timeout: 1s}").text,
              "expect \"   100\" on HEX within 1s");
    EXPECT_EQ(step("take-screenshot: {save-to: a.png}").text, "take screenshot a.png");
}

TEST(SayStep, NeverPrintsAControlCharacter) {
    EXPECT_EQ(step("wait-serial: \"a\\e[31m\\n\"").text,
              "wait for \"a\\x1b[31m\\x0a\" on the serial line within 10s");
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

TEST(SevenSegment, ReadsASixWithoutItsBarWhereASixIsExpectedAndElseAsB) {
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

TEST(SevenSegment, ShowsAQuestionMarkForAPatternThatIsNoCharacter) {
    EXPECT_EQ(hex_text({0x01, 0x3F, 0x3F, 0x3F, 0x3F, 0x3F}), "00000?");
}

}  // namespace
