// tap_test.cpp - a program's own checks: TAP on the console, and two reports of them compared
#include "sim/report/tap.h"

#include <gmock/gmock.h>

#include "sim/report/compare.h"

namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

std::vector<sim::Check> tap_checks(const std::string& console) {
    sim::TapReader reader;
    for (const char c : console) reader.print(c);
    return reader.checks();
}

std::vector<std::string> read(const std::string& lines) {
    std::vector<std::string> all;
    for (const sim::Check& check : tap_checks("TAP version 13\n" + lines))
        all.push_back((check.met ? "+" : "-") + check.name + "|" + check.detail);
    return all;
}

TEST(Tap, IsNoneWithoutItsFirstLine) {
    EXPECT_THAT(tap_checks("ok 1 - a\nready\n"), IsEmpty());
    EXPECT_THAT(tap_checks(""), IsEmpty());
}

TEST(Tap, BeginsAfterWhatTheProgramHasPrinted) {
    const auto checks = tap_checks("ready\r\nTAP version 13\r\nok 1 - a\r\n1..1\r\n");
    ASSERT_EQ(checks.size(), 1u);
    EXPECT_EQ(checks[0].name, "a");
}

// The examples of testanything.org's specification of version 13.
TEST(Tap, ReadsResultsAsTheSpecificationWritesThem) {
    EXPECT_THAT(read("1..4\n"
                     "ok 1 - Input file opened\n"
                     "not ok 2 - First line of the input valid\n"
                     "ok 3 - Read the rest of the file\n"
                     "not ok 4 - Summarized correctly # TODO Not written yet\n"),
                ElementsAre("+Input file opened|", "-First line of the input valid|",
                            "+Read the rest of the file|", "+Summarized correctly|"));
    EXPECT_THAT(read("ok\nnot ok\nok 23 # skip Insufficient flogiston pressure.\n"),
                ElementsAre("+check 1|", "-check 2|", "+check 3|"));
}

TEST(Tap, TakesWhatStandsAfterAColonAsTheDetail) {
    EXPECT_THAT(read("not ok 1 - LEDR: 0x1, expected 0x2: a bit\n"),
                ElementsAre("-LEDR|0x1, expected 0x2: a bit"));
}

TEST(Tap, PassesOverCommentsAndOtherLines) {
    EXPECT_THAT(read("# press 1\nokay\nok 1 - a\n  ---\n  message: x\n  ...\nnot okay\n"),
                ElementsAre("+a|"));
}

TEST(Tap, MissesChecksThatThePlanPromised) {
    EXPECT_THAT(read("1..3\nok 1 - a\n"),
                ElementsAre("+a|", "-the plan|3 checks were promised, 1 made"));
    EXPECT_THAT(read("1..1\n"), ElementsAre("-the plan|1 checks were promised, 0 made"));
}

TEST(Tap, EndsAtABailOut) {
    EXPECT_THAT(read("1..9\nok 1 - a\nBail out! no board\nok 2 - b\n"),
                ElementsAre("+a|", "-bail out|no board"));
}

TEST(Tap, ReadsALineThatIsNotEndedYet) {
    EXPECT_THAT(read("ok 1 - a\nok 2 - b"), ElementsAre("+a|", "+b|"));
}

TEST(Tap, ReadsChecksAfterAnyAmountOfText) {
    const auto checks =
        tap_checks(std::string(5'000'000, 'x') + "\nTAP version 13\nnot ok 1 - late\n");
    ASSERT_EQ(checks.size(), 1u);
    EXPECT_EQ(checks[0].name, "late");
}

TEST(Tap, KeepsSoManyChecksAndReportsWhenThereWereMore) {
    std::string lines;
    for (std::size_t i = 0; i < sim::TapReader::CHECKS; ++i) lines += "ok\n";
    EXPECT_EQ(read(lines).size(), sim::TapReader::CHECKS);
    const auto more = read(lines + "not ok\n");
    ASSERT_EQ(more.size(), sim::TapReader::CHECKS + 1);
    EXPECT_EQ(more.back(),
              "-the number of checks|100001 were made, only the first 100000 are kept");
}

TEST(Tap, CutsALineThatNeverEnds) {
    const auto checks = read("not ok 1 - " + std::string(10'000'000, 'x'));
    ASSERT_EQ(checks.size(), 1u);
    EXPECT_LT(checks[0].size(), 5000u);
}

// ---- Compare ----

std::string report(const std::string& checks, const char* passed = "true") {
    return R"({"passed": )" + std::string{passed} + R"(, "checks": [)" + checks + "]}";
}
const std::string LEDS = R"({"name": "LEDs", "met": true, "detail": "0x1"})";
const std::string KEYS = R"({"name": "keys", "met": true, "detail": "4"})";
const std::string NO_KEYS = R"({"name": "keys", "met": false, "detail": "3"})";

std::vector<std::string> compare(const std::string& a, const std::string& b) {
    return sim::differences(a, "a.json", b, "b.json");
}

TEST(Compare, FindsNothingBetweenTheSameChecksInAnyOrder) {
    EXPECT_THAT(compare(report(LEDS + "," + KEYS), report(KEYS + "," + LEDS)), IsEmpty());
}

TEST(Compare, ReportsAResultThatDiffersFromBothSides) {
    EXPECT_THAT(compare(report(LEDS + "," + KEYS), report(LEDS + "," + NO_KEYS, "false")),
                ElementsAre("keys\n  a.json: met: 4\n  b.json: not met: 3"));
}

TEST(Compare, ReportsAnotherDetailAlthoughBothAreMet) {
    const std::string other = R"({"name": "LEDs", "met": true, "detail": "0x2"})";
    EXPECT_THAT(compare(report(LEDS), report(other)),
                ElementsAre("LEDs\n  a.json: met: 0x1\n  b.json: met: 0x2"));
}

TEST(Compare, ReportsACheckThatOneSideLacks) {
    const auto missing = ElementsAre("keys\n  a.json: no such check\n  b.json: met: 4");
    EXPECT_THAT(compare(report(LEDS), report(LEDS + "," + KEYS)), missing);
    EXPECT_THAT(compare(report(LEDS + "," + KEYS), report(LEDS)),
                ElementsAre("keys\n  a.json: met: 4\n  b.json: no such check"));
}

TEST(Compare, ReportsARunThatFailedForAnotherReason) {
    EXPECT_THAT(compare(report(LEDS), report(LEDS, "false")),
                ElementsAre("passed\n  a.json: yes\n  b.json: no"));
}

TEST(Compare, RefusesWhatIsNoReportWithChecks) {
    for (const std::string text :
         {"", "[]", "{", R"({"passed": true})", R"({"passed": 1, "checks": []})",
          R"({"passed": true, "checks": [{"name": 1, "met": true, "detail": ""}]})"})
        try {
            (void)compare(report(LEDS), text);
            ADD_FAILURE() << text;
        } catch (const std::runtime_error& error) {
            EXPECT_THAT(error.what(), HasSubstr("b.json: expected a report with checks, got: "));
        }
}

}  // namespace
