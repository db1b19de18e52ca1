// check_board_test.cpp - check-board and compare: simulation and board's program side by side
#include <gmock/gmock.h>

#include "tb/system/cli.h"

namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

class CheckBoard : public tb::CommandLine {
protected:
    std::filesystem::path report_of(const std::string& run) const {
        return folder / (run + "/report.json");
    }
    nlohmann::json checks(const std::string& run) const {
        return nlohmann::json::parse(folder.get(run + "/report.json"))["checks"];
    }
    tb::Outcome check(const std::string& run, std::vector<std::string> arguments = {}) const {
        arguments.insert(arguments.begin(), {"check-board", "--quiet", "--out", folder / run});
        return de1sim(arguments);
    }
};

TEST_F(CheckBoard, PassesInTheSimulation) {
    const tb::Outcome outcome = check("native");
    EXPECT_EQ(outcome.exit_code, 0);
    EXPECT_EQ(outcome.err, "");
    const nlohmann::json all = checks("native");
    EXPECT_EQ(all.size(), 20u);
    for (const auto& one : all) EXPECT_TRUE(one["met"].get<bool>()) << one;
}

// The board's own program, which writes its report as it does on the board.
TEST_F(CheckBoard, AgreesWithTheBoardsOwnProgram) {
    ASSERT_EQ(check("native").exit_code, 0);
    std::filesystem::create_directories(folder / "root");
    const std::string scenario = std::string{SOURCE} + "/sim/run/check_board.yaml";
    const tb::Outcome outcome =
        play(scenario, {"--quiet", "--frames", "none", "--cpu", "arm", "--elf",
                        FIRMWARE "collide-linux", "--linux-root", folder / "root", "--duration",
                        "3s", "--", "--self-test=/board.json"});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;

    const std::filesystem::path board = folder / "root/board.json";
    EXPECT_EQ(nlohmann::json::parse(folder.get("root/board.json"))["cpu"], "board");
    const tb::Outcome same = de1sim({"compare", report_of("native"), board});
    EXPECT_EQ(same.exit_code, 0) << same.out;
    EXPECT_EQ(same.out, "the same checks with the same results\n");

    std::string text = folder.get("root/board.json");
    text.replace(text.find("0x000003FF"), 10, "0x000003FE");
    folder.put("other.json", text);
    const tb::Outcome differ = de1sim({"compare", report_of("native"), folder / "other.json"});
    EXPECT_EQ(differ.exit_code, 1);
    EXPECT_THAT(differ.out, HasSubstr("LEDR reads back\n"));
    EXPECT_THAT(differ.out, HasSubstr("1 of the checks differ\n"));
}

TEST_F(CheckBoard, RunsTheBoardsProgramByOneOption) {
    EXPECT_EQ(check("arm", {"--elf", FIRMWARE "collide-linux"}).exit_code, 0);
    EXPECT_EQ(checks("arm").size(), 20u);
}

TEST_F(CheckBoard, CompareRefusesWhatItCannotRead) {
    folder.put("empty.json", "{}");
    for (const std::string name : {"empty.json", "none.json"}) {
        const tb::Outcome outcome = de1sim({"compare", folder / name, folder / name});
        EXPECT_EQ(outcome.exit_code, 2);
        EXPECT_EQ(outcome.out, "");
        EXPECT_EQ(tb::lines_of(outcome.err).size(), 1u) << outcome.err;
        EXPECT_THAT(outcome.err, HasSubstr(name));
    }
}

// Any program's TAP counts, not only the self-test's.
TEST_F(CheckBoard, AProgramsOwnFailedCheckFailsTheRun) {
    const tb::Outcome outcome =
        play(scenario("duration: 20ms\n"),
             {"--cpu", "arm", "--elf", LINUX_PROGRAMS "tap", "--frames", "none", "--quiet"});
    EXPECT_EQ(outcome.exit_code, 1);
    EXPECT_THAT(outcome.err, HasSubstr("adds: not met: 2 + 2 is 5\n"));
    EXPECT_THAT(file("junit.xml"), HasSubstr("<failure message=\"2 + 2 is 5\">"));
    EXPECT_EQ(report()["checks"].size(), 2u);
}

}  // namespace
