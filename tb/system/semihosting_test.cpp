// semihosting_test.cpp - programs that ask a debugger to print, read and end
#include <gmock/gmock.h>

#include "tb/system/cli.h"

namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::EndsWith;
using ::testing::HasSubstr;
using ::testing::SizeIs;

// The program's own requests are in ARM code, newlib's in Thumb code.
class Semihosting : public tb::CommandLine {
protected:
    tb::Outcome typed(const std::string& text, const std::string& duration = "60ms") const {
        return play(
            scenario("duration: " + duration + "\nsteps:\n  - type-serial: \"" + text + "\"\n"),
            {"--elf", SEMIHOSTING_ELF, "--frames", "none", "--quiet"});
    }
    std::string console() const { return file("console.txt"); }
    std::vector<std::string> log() const { return report()["log"]["first"]; }
};

TEST_F(Semihosting, PrintsAndEndsAsUnderQemu) {
    const tb::Outcome outcome = de1sim({SEMIHOSTING_ELF, "--out", out.string()});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_EQ(report()["end"], "the program ended");
    EXPECT_EQ(report()["program"]["exit_code"], 0);
    EXPECT_EQ(console(), "half of 3 is 1.5\nan error of 7\na, input ends\n");

    tb::Command qemu;
    qemu.arguments = {QEMU_ARM, "-cpu", "cortex-a9", SEMIHOSTING_ELF};
    qemu.shell = "exec </dev/null 2>&1";
    const tb::Outcome reference = run_program(qemu);
    EXPECT_EQ(reference.exit_code, 0);
    EXPECT_EQ(reference.out, console());
}

TEST_F(Semihosting, WarnsOnceThatTheBoardNeedsADebugger) {
    typed("\\x04");
    EXPECT_THAT(log(), ElementsAre(AllOf(HasSubstr("semihosting: answered as by a debugger"),
                                         HasSubstr("PC 0x"))));
}

TEST_F(Semihosting, ReadsWhatIsTypedAtTheSerialLine) {
    EXPECT_EQ(typed("echo\\nsome words\\nx\\n").exit_code, 0);
    EXPECT_THAT(console(), HasSubstr("read: some words\n"));
    EXPECT_THAT(console(), EndsWith("then 'x'\n"));
}

TEST_F(Semihosting, WaitsForInputThatNeverComes) {
    const tb::Outcome outcome = play(scenario("duration: 20ms\n"), {"--elf", SEMIHOSTING_ELF});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_EQ(report()["program"]["at"]["waiting_for"], "standard input");
}

TEST_F(Semihosting, HasAnExitCodeOtherThan0AsAFault) {
    EXPECT_EQ(typed("exit\\n").exit_code, 1);
    EXPECT_EQ(report()["program"]["exit_code"], 7);
    ASSERT_THAT(report()["faults"], SizeIs(1));
    EXPECT_THAT(report()["faults"][0].get<std::string>(),
                HasSubstr("the program ended with exit code 7 at "));
}

TEST_F(Semihosting, HasAnAbortAsAFault) {
    EXPECT_EQ(typed("abort\\n").exit_code, 1);
    EXPECT_EQ(report()["program"]["exit_code"], 1) << "as under QEMU";
    EXPECT_THAT(report()["faults"], SizeIs(1));
}

TEST_F(Semihosting, OpensNoFileAndNamesTheFirst) {
    EXPECT_EQ(typed("files\\n").exit_code, 0);
    EXPECT_THAT(console(), EndsWith("open: 2\nremove: -1\nagain: 2\n"));
    ASSERT_THAT(log(), SizeIs(3));
    EXPECT_THAT(log()[1], HasSubstr("\"none.txt\" is not opened: there is only the console"));
    EXPECT_THAT(log()[2], HasSubstr("operation 0x0E, SYS_REMOVE, is not answered"));
}

// 115,200 baud with a start and a stop bit, behind a buffer of 4,096 characters.
TEST_F(Semihosting, PrintsNoFasterThanTheSerialLineOfTheBoard) {
    EXPECT_EQ(typed("print\\n", "1s").exit_code, 0);
    EXPECT_GT(console().size(), 11'400u);
    EXPECT_LE(console().size(), 11'520u + 4'096);
}

TEST_F(Semihosting, AnswersAsTheStandardSays) {
    EXPECT_EQ(typed("ask\\n").exit_code, 0);
    const std::string name = std::filesystem::path{SEMIHOSTING_ELF}.filename().string();
    EXPECT_THAT(tb::lines_of(console()),
                ElementsAre("ask", "unknown -1, errno 1", "nowhere -1, errno 1", "no handle -1",
                            "console 1, 0, 0",
                            "command line 0 '" + name + "' " + std::to_string(name.size()) + ", -1",
                            "ticks 0 per second 1: 1", "write0", "c", "1 0"));
    EXPECT_THAT(log(), ElementsAre(HasSubstr("answered as by a debugger"),
                                   HasSubstr("operation 0x00 is not answered"),
                                   HasSubstr("operation 0x99 is not answered")));
}

TEST_F(Semihosting, CountsSimulatedSeconds) {
    play(scenario("duration: 1050ms\nsteps:\n  - delay: 1s\n  - type-serial: \"time\\n\"\n"),
         {"--elf", SEMIHOSTING_ELF, "--frames", "none", "--quiet"});
    EXPECT_THAT(console(), EndsWith("\n1 s\n"));
}

}  // namespace
