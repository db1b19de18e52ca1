// cli_print_test.cpp - what a program prints is on standard output as it comes, and never lost.
#include <gmock/gmock.h>

#include <fstream>

#include "tb/system/cli.h"

namespace {

using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

const std::string LINE = "first line\n", PROMPT = "\x1b[2J\xffname: ";

class PrintingProgram : public tb::CommandLine {
protected:
    std::string duration = "5ms";

    tb::Outcome run(const std::string& elf, std::vector<std::string> arguments = {},
                    tb::Command command = {}) const {
        arguments.insert(arguments.begin(), {elf, "--out", out.string(), "--frames", "none"});
        arguments.insert(arguments.end(), {"--duration", duration});
        return de1sim(arguments, command);
    }
};

TEST_F(PrintingProgram, LosesNothingThatItPrintedBeforeItDied) {
    const tb::Outcome outcome = run(CRASH_REPORT_ELF);
    EXPECT_EQ(outcome.exit_code, 1);
    for (const char letter : {'a', 'b', 'c'}) {
        const std::string all = file("console.txt");
        EXPECT_EQ(std::count(all.begin(), all.end(), letter), 64) << letter;
        EXPECT_EQ(std::count(outcome.out.begin(), outcome.out.end(), letter) >= 64, true);
    }
}

TEST_F(PrintingProgram, PrintsByteForByteBeforeTheSummary) {
    const tb::Outcome outcome = run(PROMPTS_ELF);
    EXPECT_THAT(outcome.out, StartsWith(LINE + PROMPT + "\nprompts.elf: duration reached; "));
    EXPECT_THAT(outcome.err, Not(HasSubstr("first")));
    EXPECT_EQ(file("console.txt"), LINE + PROMPT);
}

TEST_F(PrintingProgram, IsReadWhileItRuns) {
    const std::string printed = folder / "printed";
    tb::Command command;
    command.shell = "exec >'" + printed + "'";
    command.interrupt_when = [&] {
        std::ifstream in{printed, std::ios::binary};
        return std::string{std::istreambuf_iterator<char>{in}, {}} == LINE + PROMPT;
    };
    duration = "1000s";
    EXPECT_EQ(run(PROMPTS_ELF, {}, command).exit_code, 130);
}

TEST_F(PrintingProgram, IsKeptFromStandardOutputByQuiet) {
    const tb::Outcome outcome = run(PROMPTS_ELF, {"--quiet"});
    EXPECT_EQ(outcome.out, "");
    EXPECT_EQ(file("console.txt"), LINE + PROMPT);
}

TEST_F(PrintingProgram, IsNotJoinedWithAMessageOnOneLine) {
    tb::Command command;
    command.shell = "exec 2>&1";
    const tb::Outcome outcome = run(PROMPTS_ELF, {}, command);
    EXPECT_THAT(outcome.out, HasSubstr(PROMPT + "\nde1sim: the program was at"));
    EXPECT_THAT(run(CRASH_REPORT_ELF, {}, command).out, HasSubstr("\nde1sim: the program ran off"));
}

TEST_F(PrintingProgram, RunsOnWhereNobodyReadsItsOutput) {
    tb::Command command;
    command.shell = "exec >/dev/full";
    const tb::Outcome outcome = run(PROMPTS_ELF, {}, command);
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_THAT(outcome.err, HasSubstr("standard output could not be written"));
    EXPECT_EQ(file("console.txt"), LINE + PROMPT);
}

}  // namespace
