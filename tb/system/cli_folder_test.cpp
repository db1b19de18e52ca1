// cli_folder_test.cpp - the output folder: one run at a time, and names that only the run writes.
#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>
#include <regex>

#include "tb/system/cli.h"

namespace {

using ::testing::AllOf;
using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;
using ::testing::SizeIs;

class OutputFolder : public tb::CommandLine {
protected:
    // Another run into the same folder, or into `folder_name`, while the first one plays.
    tb::Outcome during_a_run(const std::string& folder_name, int then_ended_by) {
        tb::Outcome second;
        tb::Command first;
        first.interrupt_by = then_ended_by;
        first.interrupt_when = [&] {
            if (!std::filesystem::exists(out / frame(2))) return false;
            second = de1sim({"run", "s.yaml", "--out", folder_name, "--duration", "20ms"});
            command_line_of_holder = command_line_of(second.err);
            first_frame_stayed = std::filesystem::exists(out / frame(1));
            return true;
        };
        first_run = play(scenario("duration: 1000s\n"), {"--frames", "all"}, first);
        return second;
    }

    tb::Outcome first_run;
    std::string command_line_of_holder;  // of the process that the second run named
    bool first_frame_stayed = false;

private:
    static std::string command_line_of(const std::string& message) {
        std::smatch pid;
        if (!std::regex_search(message, pid, std::regex{"PID ([0-9]+)"})) return "";
        std::ifstream file{"/proc/" + pid[1].str() + "/cmdline", std::ios::binary};
        return {std::istreambuf_iterator<char>(file), {}};
    }
};

TEST_F(OutputFolder, InUseIsRefusedNamingTheFirstRun) {
    const tb::Outcome second = during_a_run(out, SIGINT);
    EXPECT_EQ(second.exit_code, 2);
    EXPECT_EQ(second.out, "");
    EXPECT_THAT(tb::lines_of(second.err), SizeIs(1));
    EXPECT_THAT(second.err,
                HasSubstr(out.string() + ": another run is writing into this folder (PID "));
    EXPECT_THAT(command_line_of_holder, AllOf(HasSubstr("s.yaml"), Not(HasSubstr("20ms"))));
}

TEST_F(OutputFolder, InUseIsNotTouchedByTheRefusedRun) {
    during_a_run(out, SIGINT);
    EXPECT_TRUE(first_frame_stayed);
    EXPECT_EQ(first_run.exit_code, 130);
    EXPECT_TRUE(report()["interrupted"]);
    for (unsigned number = 1; number <= report()["frames"]["shown"]; ++number)
        EXPECT_THAT(files(), Contains(frame(number)));
}

TEST_F(OutputFolder, IsKnownByAnotherNameToo) {
    std::filesystem::create_directory(out);
    std::filesystem::create_directory_symlink(out, folder / "link");
    EXPECT_EQ(during_a_run(folder / "link", SIGINT).exit_code, 2);
}

TEST_F(OutputFolder, OfARunThatWasKilledIsFree) {
    EXPECT_EQ(during_a_run(folder / "elsewhere", SIGKILL).exit_code, 0);
    EXPECT_EQ(first_run.exit_code, -SIGKILL);
    EXPECT_EQ(play("s.yaml", {"--duration", "20ms"}).exit_code, 0);
}

TEST_F(OutputFolder, WithoutANameIsRefused) {
    scenario("duration: 100ms\n");
    for (const auto& arguments :
         {std::vector<std::string>{"run", "s.yaml", "--out", ""}, {"check-board", "--out", ""}}) {
        const tb::Outcome outcome = de1sim(arguments);
        EXPECT_EQ(outcome.exit_code, 2);
        EXPECT_THAT(tb::lines_of(outcome.err), SizeIs(1));
        EXPECT_THAT(outcome.err, HasSubstr("--out: expected a name, got an empty one"));
    }
}

TEST_F(OutputFolder, WithAScreenshotNamedReportIsRefused) {
    const tb::Outcome outcome = play(
        scenario("steps:\n  - delay: 20ms\n  - take-screenshot: {save-to: junit.xml/x.png}\n"));
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_THAT(outcome.err, HasSubstr("s.yaml:5:5: expected a file that the run does not write "
                                       "itself, got \"junit.xml/x.png\""));
    EXPECT_THAT(files(), IsEmpty());
}

TEST_F(OutputFolder, EmptyNamesOfOtherFilesAreRefusedToo) {
    scenario("duration: 100ms\n");
    const auto refused = [this](const std::vector<std::string>& arguments, const char* what) {
        const tb::Outcome outcome = de1sim(arguments);
        EXPECT_EQ(outcome.exit_code, 2) << what;
        EXPECT_THAT(outcome.err, HasSubstr(std::string{what} + ": expected a name, got an empty"));
    };
    refused({"run", "s.yaml", "--out", out, "--trace", ""}, "--trace");
    refused({"run", ""}, "FILE");
    refused({"compare", "", "b"}, "A");
}

}  // namespace
