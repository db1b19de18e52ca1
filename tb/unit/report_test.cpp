// report_test.cpp - report.json and junit.xml, as other programs read them
#include "sim/report/report.h"

#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "sim/report/report_keys.h"
#include "tb/support/temp_folder.h"

namespace {

using namespace sim;
using nlohmann::json;

RunReport sample() {
    RunReport r;
    r.scenario = "Two shapes";
    r.file = "demo.yaml";
    r.seed = 18446744073709551615u;
    r.cpu = "arm";
    r.end = RunEnd::DURATION_REACHED;
    r.simulated_s = 2.5;
    r.wall_s = 5;
    r.frames_shown = 150;
    r.frames_swapped = 75;
    r.last_frame_sha256 = "e3b0";
    r.signal = "640 x 480";
    r.pictures = {{1, "aa"}, {10, "bb"}};
    r.bus = {1, 2, 3, 4};
    r.audio = {8000.0, 20000, 6};
    r.key_events = 8;
    const RunReport::Shown::Fields digits{{"text", "    12"}, {"segments", "00 00 00 00 06 5B"}};
    const RunReport::Shown::Fields lamps{{"lit", "0000000001"}}, led{{"lit", "1"}};
    r.shown = {
        {"hex", digits, {{0.5, digits}}, 41}, {"ledr", lamps, {}, 0}, {"hps_led", led, {}, 0}};
    r.parts = {{"face", {"#.", ".+"}}, {"t", {}, "ok\a", 1}};
    r.characters = {"", " hello", ""};
    r.timing_violation_count = 1;
    r.timing_violations = {"H total 799"};
    r.sdram_violation_count = 2;
    r.sdram_violations = {"READ at 1.00 us: bank 1 has no open row"};
    r.expectations = {{"expect LEDs 1", 7, 0.25, true, ""},
                      {"expect silence", 9, 1.5, false, "a sample of 3"}};
    return r;
}

class Junit : public testing::Test {
protected:
    // An XPath expression, evaluated by xmllint, which also checks the XML.
    std::string xpath(const RunReport& report, const std::string& expression) {
        folder.put("junit.xml", to_junit(report));
        const std::string file = (folder / "junit.xml").string();
        std::string out = output_of("xmllint --noout " + file + " 2>&1");
        if (out.empty()) out = output_of("xmllint --xpath '" + expression + "' " + file + " 2>&1");
        if (!out.empty() && out.back() == '\n') out.pop_back();
        return out;
    }
    TempFolder folder;
};

TEST(ReportJson, HasEverythingThatTheRunKnows) {
    EXPECT_EQ(json::parse(to_json(sample())), json::parse(R"({
        "format": 1, "scenario": "Two shapes", "file": "demo.yaml",
        "seed": 18446744073709551615, "cpu": "arm",
        "end": "duration reached", "interrupted": false, "passed": false, "simulated_s": 2.5,
        "frames": {"shown": 150, "swapped": 75, "last_sha256": "e3b0",
                   "signal": "640 x 480", "pictures": {"1": "aa", "10": "bb"}},
        "bus": {"reads": 1, "writes": 2, "bursts": 3, "errors": 4},
        "audio": {"rate_hz": 8000.0, "samples": 20000, "underruns": 6},
        "key_events": 8,
        "final": {"hex": "    12", "ledr": "0000000001", "hps_led": "1"},
        "shown": {
            "ledr": {"lit": "0000000001", "changes": {"count": 0, "first": []}},
            "hps_led": {"lit": "1", "changes": {"count": 0, "first": []}},
            "hex": {"text": "    12", "segments": "00 00 00 00 06 5B",
                    "changes": {"count": 42, "first": [
                        {"time_s": 0.5, "text": "    12", "segments": "00 00 00 00 06 5B"}]}}},
        "parts": {"face": {"rows": ["#.", ".+"]}, "t": {"received": "ok\\x07", "lost": 1}},
        "characters": [{"row": 1, "text": " hello"}],
        "timing_violations": {"count": 1, "first": ["H total 799"]},
        "sdram_violations": {"count": 2, "first": ["READ at 1.00 us: bank 1 has no open row"]},
        "expectations": [
            {"step": "expect LEDs 1", "line": 7, "time_s": 0.25, "met": true, "detail": ""},
            {"step": "expect silence", "line": 9, "time_s": 1.5, "met": false,
             "detail": "a sample of 3"}],
        "faults": [], "log": {"lines": 0, "first": []},
        "wall": {"seconds": 5.0, "frames_per_s": 30.0}})"));
}

// The paths of all that is in a file, with [] for a list's entries.
void collect_paths(const json& value, const std::string& path, std::set<std::string>& all) {
    if (value.is_array())
        for (const json& entry : value) collect_paths(entry, path + "[]", all);
    else if (value.is_object())
        for (const auto& [name, inner] : value.items())
            collect_paths(inner, path.empty() ? name : path + "." + name, all);
    else
        all.insert(path);
}

// Whether a path is of a key, in which "*" is any name.
bool is_of(const std::string& path, std::string_view key) {
    std::istringstream ours{path}, theirs{std::string{key}};
    for (std::string name, wanted;;) {
        const bool more = bool(std::getline(ours, name, '.'));
        if (more != bool(std::getline(theirs, wanted, '.'))) return false;
        if (!more) return true;
        if (wanted != "*" && wanted != name) return false;
    }
}

TEST(ReportKeys, AreThoseOfTheFile) {
    RunReport full = sample();
    full.faults = {"a fault"};
    full.log = {"a line"};
    full.checks = {{"adds", true, ""}};
    full.program = RunReport::Program{};
    full.program->exit_code = 0;
    full.program->network = {"127.0.0.1:80"};
    full.program->frames.count = 1;
    std::set<std::string> paths;
    collect_paths(json::parse(to_json(full)), "", paths);
    for (const std::string& path : paths)
        EXPECT_TRUE(std::any_of(std::begin(REPORT_KEYS), std::end(REPORT_KEYS),
                                [&](const ReportKey& key) { return is_of(path, key.path); }))
            << path << " is in report.json and not in report_keys.h";
    for (const ReportKey& key : REPORT_KEYS)
        EXPECT_TRUE(key.path == "shown" ||
                    std::any_of(paths.begin(), paths.end(),
                                [&](const std::string& path) { return is_of(path, key.path); }))
            << key.path << " is in report_keys.h and not in report.json";
}

TEST(ReportJson, HasWhereAProgramOfTheArmWas) {
    sim::RunReport r = sample();
    r.program = sim::RunReport::Program{};
    r.program->elf = "a.elf";
    r.program->cpi = 1.5;
    r.program->instructions = 1000;
    r.program->interrupts = 3;
    r.program->aborts = 2;
    r.program->asleep_s = 0.25;
    r.program->on_bus_s = 0.5;
    r.program->pc = 0x100;
    r.program->function = "main+0x4";
    r.program->waiting = "a change of 0xFF200050";
    json program = json::parse(to_json(r))["program"];
    program.erase("frames");  // which other tests check
    EXPECT_EQ(program, json::parse(R"({
        "elf": "a.elf", "cpi": 1.5, "instructions": 1000, "interrupts": 3, "aborts": 2,
        "asleep_s": 0.25, "on_bus_s": 0.5,
        "at": {"pc": "0x00000100", "function": "main+0x4",
               "waiting_for": "a change of 0xFF200050"}})"));
}

TEST(ReportJson, KeepsTheOrderOfItsKeys) {
    const std::string text = to_json(sample());
    std::size_t last = 0;
    for (const char* key :
         {"scenario", "seed", "end", "frames", "bus", "audio", "faults", "wall"}) {
        const std::size_t at = text.find("\n  \"" + std::string(key) + "\": ");
        ASSERT_NE(at, text.npos) << key;
        EXPECT_GT(at + 1, last) << key;
        last = at + 1;
    }
    EXPECT_EQ(text.back(), '\n');
}

TEST(ReportJson, ListsTheFirstTwentyTimingViolations) {
    RunReport r = sample();
    r.timing_violation_count = 1000;
    r.timing_violations.assign(30, "x");
    const json timing = json::parse(to_json(r))["timing_violations"];
    EXPECT_EQ(timing["count"], 1000);
    EXPECT_EQ(timing["first"].size(), 20u);
}

TEST(ReportJson, StaysValidWhateverTheTextsHold) {
    RunReport r = sample();
    r.faults = {std::string("\xFF\0\x1B\"", 4)};
    r.wall_s = 0;
    EXPECT_EQ(json::parse(to_json(r))["faults"][0], std::string("\xEF\xBF\xBD\0\x1B\"", 6));
}

TEST(Report, PassesWhenAllIsMetAndNothingWentWrong) {
    RunReport r = sample();
    EXPECT_FALSE(r.passed());
    r.expectations.pop_back();
    EXPECT_TRUE(r.passed());
    r.faults = {"data abort"};
    EXPECT_FALSE(r.passed());
    r.faults.clear();
    r.end = RunEnd::INTERRUPTED;
    EXPECT_FALSE(r.passed());
    r.end = RunEnd::FIRMWARE_FAULT;
    EXPECT_FALSE(r.passed());
}

TEST_F(Junit, HasATestCasePerExpectationAndOneForTheRun) {
    EXPECT_EQ(xpath(sample(), "string(/testsuites/testsuite/@tests)"), "3");
    EXPECT_EQ(xpath(sample(), "string(/testsuites/testsuite/@failures)"), "1");
    EXPECT_EQ(xpath(sample(), "string(/testsuites/testsuite/@errors)"), "0");
    EXPECT_EQ(xpath(sample(), "count(//testcase)"), "3");
    EXPECT_EQ(xpath(sample(), "string(//testcase[1]/@name)"), "demo.yaml:7: expect LEDs 1");
    EXPECT_EQ(xpath(sample(), "string(//testcase[1]/@time)"), "0.250000");
    EXPECT_EQ(xpath(sample(), "string(//testcase[3]/@name)"), "the run");
}

TEST_F(Junit, HasAFailureForWhatWasNotMet) {
    EXPECT_EQ(xpath(sample(), "count(//failure)"), "1");
    EXPECT_EQ(xpath(sample(), "string(//testcase[2]/failure/@message)"), "a sample of 3");
}

TEST_F(Junit, HasAnErrorForFaultsAndInterruptions) {
    RunReport r = sample();
    r.faults = {"data abort at 0xff200100", "second"};
    EXPECT_EQ(xpath(r, "string(//testcase[3]/error/@message)"), "data abort at 0xff200100");
    EXPECT_EQ(xpath(r, "string(/testsuites/@errors)"), "1");
    r.faults.clear();
    r.end = RunEnd::INTERRUPTED;
    EXPECT_EQ(xpath(r, "string(//error/@message)"), "the run was interrupted");
}

TEST_F(Junit, IsValidXmlWhateverTheTextsHold) {
    RunReport r = sample();
    r.scenario = "<&>\"'";
    r.expectations[1].detail = std::string("]]> \0\x1B\n\xFF \xEF\xBF\xBE", 12);
    EXPECT_EQ(xpath(r, "string(/testsuites/@name)"), "<&>\"'");
    EXPECT_EQ(xpath(r, "string(//failure)"), "]]> \\x00\\x1b\\x0a\\xff \\xef\\xbf\\xbe");
}

TEST_F(Junit, HasNoWallClockInIt) {
    RunReport slow = sample();
    slow.wall_s = 77;
    EXPECT_EQ(to_junit(slow), to_junit(sample()));
}

}  // namespace
