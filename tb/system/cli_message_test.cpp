// cli_message_test.cpp - messages never end a run, and a run that fails reports it.
#include <gmock/gmock.h>

#include <csignal>

#include "tb/system/cli.h"

namespace {

using ::testing::Contains;
using ::testing::Each;
using ::testing::EndsWith;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;
using ::testing::SizeIs;

const std::set<std::string> FILES{"audio.wav", "console.txt", "junit.xml", "report.json"};

// After a simulated second there is a line of progress.
constexpr const char *WITH_PROGRESS = "duration: 1010ms\n", *WITHOUT = "duration: 100ms\n";

class Message : public tb::CommandLine {
protected:
    // `shell` is what a shell does first.
    tb::Outcome play_after(const std::string& shell, const char* duration,
                           const std::string& program = DE1SIM) const {
        tb::Command command;
        command.shell = shell;
        return play(scenario(duration), {"--frames", "none"}, command, program);
    }
    void expect_all_files() const {
        EXPECT_EQ(files(), FILES);
        EXPECT_EQ(file("console.txt"), "ready\r\n");
        EXPECT_TRUE(report()["passed"]);
    }
};

TEST_F(Message, ThatCanNotBeWrittenKeepsTheRun) {
    EXPECT_EQ(play_after("exec 2>/dev/full", WITH_PROGRESS).exit_code, 0);
    expect_all_files();
}

TEST_F(Message, ThatCanNotBeWrittenKeepsTheExitCode) {
    tb::Command command;
    command.shell = "exec 2>/dev/full";
    EXPECT_EQ(play("none.yaml", {}, command).exit_code, 2);
    EXPECT_EQ(de1sim({"walk"}, command).exit_code, 2);
    EXPECT_EQ(play(scenario("steps:\n  - expect-leds: 1\n"), {}, command).exit_code, 1);
    EXPECT_FALSE(report()["passed"]);
}

TEST_F(Message, WithoutAReaderLeavesTheRunAsItIs) {
    const std::string pipe = folder / "pipe";
    const std::string shell =
        "mkfifo '" + pipe + "'; true <'" + pipe + "' & exec 2>'" + pipe + "'; wait";
    EXPECT_EQ(play_after(shell, WITHOUT, NEVER_SWAPS).exit_code, 0);  // which is reported
    EXPECT_TRUE(report()["passed"]);
}

TEST_F(Message, GoesNowhereWhereStderrIsClosedAndIntoNoFile) {
    EXPECT_EQ(play_after("exec 2>&-", WITH_PROGRESS).exit_code, 0);
    expect_all_files();
}

TEST_F(Message, GoesNowhereWhereNothingIsOpen) {
    EXPECT_EQ(play_after("exec <&- >&- 2>&-", WITHOUT).exit_code, 0);
    expect_all_files();
    EXPECT_EQ(play_after("exec <&- >&- 2>&-", WITHOUT, NEVER_SWAPS).exit_code, 0);
    EXPECT_EQ(file("console.txt"), "");
}

TEST_F(Message, OfASummaryThatCanNotBeWrittenIsExit2) {
    const tb::Outcome outcome = play_after("exec >/dev/full", WITHOUT);
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_EQ(outcome.err,
              "de1sim: standard output could not be written: No space left on device\n");
    expect_all_files();
}

TEST_F(Message, OfHelpThatCanNotBeWrittenIsExit2) {
    tb::Command command;
    command.shell = "exec >/dev/full";
    folder.put("a", "{\"passed\": true, \"checks\": []}");
    const std::string a = folder / "a";
    for (const auto& arguments :
         {std::vector<std::string>{"--help"}, {"--version"}, {"compare", a, a}}) {
        const tb::Outcome outcome = de1sim(arguments, command);
        EXPECT_EQ(outcome.exit_code, 2) << arguments[0];
        EXPECT_THAT(tb::lines_of(outcome.err), SizeIs(1));
        EXPECT_THAT(outcome.err, HasSubstr("standard output could not be written: No space left"));
    }
}

TEST_F(Message, ShowsControlCharactersOfNamesAsText) {
    const std::string name = "a\x1b[31m\nb.yaml", shown = "a\\x1b[31m\\x0ab.yaml";
    tb::Outcome outcome = play(name);
    EXPECT_THAT(outcome.err, HasSubstr(shown));
    EXPECT_THAT(tb::lines_of(outcome.err), SizeIs(1));

    const std::string elsewhere = folder / "out\x1b[0m\n";
    scenario("steps:\n  - expect-leds: 1\n", name);
    outcome = de1sim({"run", name, "--out", elsewhere, "--quiet"});
    EXPECT_EQ(outcome.exit_code, 1);
    EXPECT_THAT(outcome.err, HasSubstr(shown + ":4: expect LEDs 0000000001: not met: "));
    EXPECT_THAT(outcome.out, HasSubstr("out\\x1b[0m\\x0a\n"));
    EXPECT_THAT(outcome.out + outcome.err, Not(HasSubstr("\x1b")));
    EXPECT_THAT(tb::lines_of(outcome.out)[0], EndsWith("out\\x1b[0m\\x0a"));
    EXPECT_THAT(tb::lines_of(outcome.err), SizeIs(1));  // not that there was no picture so soon

    outcome = de1sim({"run", name, "--fr\x1b"});
    EXPECT_THAT(outcome.err, HasSubstr("--fr\\x1b"));
    outcome = de1sim({"run", name, "--cpu", "arm", "--elf", folder / "x\x1b\n"});
    EXPECT_THAT(outcome.err, HasSubstr("x\\x1b\\x0a: "));
    EXPECT_THAT(tb::lines_of(outcome.err), SizeIs(1));
}

class HungUp : public tb::CommandLine {};

TEST_F(HungUp, EndsARunLikeAnInterruption) {
    tb::Command command;
    command.interrupt_when = [this] { return std::filesystem::exists(out / frame(6)); };
    command.interrupt_by = SIGHUP;
    EXPECT_EQ(play(scenario("duration: 1000s\n"), {"--frames", "all"}, command).exit_code, 130);
    EXPECT_TRUE(report()["interrupted"]);
    EXPECT_THAT(files(), Each(Not(EndsWith(".part"))));
    EXPECT_THAT(files(), Contains("console.txt"));
}

TEST_F(HungUp, UnderNohupEndsNothing) {
    tb::Command command;
    command.interrupt_when = [this] { return std::filesystem::exists(out / frame(2)); };
    command.interrupt_by = SIGHUP;
    command.shell = "trap '' HUP";
    EXPECT_EQ(play(scenario("duration: 100ms\n"), {"--frames", "all"}, command).exit_code, 0);
    EXPECT_FALSE(report()["interrupted"]);
    EXPECT_EQ(report()["simulated_s"], 0.1);
}

class BrokenRun : public tb::CommandLine {};

TEST_F(BrokenRun, LeavesAReportOfWhatBroke) {
    const tb::Outcome outcome = play(scenario("duration: 1s\nsteps:\n  - wait-frame: 50\n"),
                                     {"--quiet", "--frames", "all"}, {}, THROWS);
    EXPECT_EQ(outcome.exit_code, 2);
    const std::string fault = "internal error while simulating, at 0.050";
    EXPECT_THAT(outcome.err, HasSubstr("de1sim: " + fault));
    EXPECT_THAT(outcome.err, HasSubstr(" s: nobody thought of \\x1b this\n"));
    ASSERT_THAT(files(), Contains("report.json"));
    EXPECT_EQ(report()["end"], "internal error");
    EXPECT_FALSE(report()["passed"]);
    EXPECT_THAT(report()["faults"].dump(), HasSubstr(fault));
    EXPECT_EQ(report()["expectations"][0]["detail"], "the run ended before");
    EXPECT_EQ(report()["frames"]["shown"], 2u);
    EXPECT_THAT(file("junit.xml"), HasSubstr("<error message=\"" + fault));
    EXPECT_EQ(file("console.txt"), "begun\r\n");
    EXPECT_THAT(files(), Contains(frame(2)));
    EXPECT_THAT(files(), Each(Not(EndsWith(".part"))));
}

#ifndef __SANITIZE_ADDRESS__  // which reports it in its own words
TEST_F(BrokenRun, ThatASignalKillsLeavesAReportThatSaysSo) {
    for (const auto& [signal, name] : {std::pair{SIGSEGV, "SIGSEGV"}, {SIGABRT, "SIGABRT"}}) {
        std::filesystem::remove_all(out);
        tb::Command command;
        command.interrupt_when = [this] { return std::filesystem::exists(out / frame(6)); };
        command.interrupt_by = signal;
        const tb::Outcome outcome =
            play(scenario("duration: 1000s\n"), {"--quiet", "--frames", "all"}, command);
        const std::string fault = std::string{"internal error: de1sim was ended by "} + name;
        EXPECT_EQ(outcome.exit_code, 2);
        EXPECT_EQ(outcome.err, "de1sim: " + fault + "\n");
        EXPECT_EQ(report()["end"], "internal error");
        EXPECT_FALSE(report()["passed"]);
        EXPECT_EQ(report()["scenario"], "test");
        EXPECT_EQ(report()["faults"], nlohmann::json::array({fault}));
        EXPECT_GE(report()["simulated_s"], 0.05);
        EXPECT_THAT(file("junit.xml"), HasSubstr("<error message=\"" + fault));
    }
}
#endif

TEST_F(BrokenRun, OfWhichTheMemoryWasNotEnoughSaysSo) {
    const tb::Outcome outcome =
        play(scenario("duration: 1s\nsteps:\n  - hold: {switch: 0}\n"), {"--quiet"}, {}, THROWS);
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_THAT(outcome.err, HasSubstr("de1sim: out of memory while simulating, at 0.050"));
    EXPECT_THAT(outcome.err, Not(HasSubstr("bad_alloc")));
    EXPECT_THAT(report()["faults"].dump(), HasSubstr("out of memory"));
}

#ifndef __SANITIZE_ADDRESS__  // which needs more address space than any limit leaves
TEST_F(BrokenRun, ForWhoseBoardThereIsNoMemoryDoesNotBegin) {
    tb::Command command;
    command.shell = "ulimit -v 900000";  // KiB; the board has 1 GiB of DDR3
    const tb::Outcome outcome = play(scenario("duration: 1s\n"), {}, command);
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_EQ(outcome.err, "de1sim: out of memory while setting up the board\n");
    EXPECT_THAT(files(), IsEmpty());
}
#endif

}  // namespace
