// cli_alone_test.cpp - a program by itself, without a scenario, and one that its scenario names.
#include <gmock/gmock.h>

#include "tb/system/cli.h"

namespace {

using ::testing::Contains;
using ::testing::ContainsRegex;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;
using ::testing::SizeIs;

class ProgramAlone : public tb::CommandLine {
protected:
    tb::Outcome alone(const std::string& elf, std::vector<std::string> arguments = {},
                      tb::Command command = {}) const {
        arguments.insert(arguments.begin(), {elf, "--out", out.string()});
        return de1sim(arguments, command);
    }
    void refused(const tb::Outcome& outcome, const std::string& message) const {
        EXPECT_EQ(outcome.exit_code, 2);
        EXPECT_THAT(tb::lines_of(outcome.err), SizeIs(1));
        EXPECT_THAT(outcome.err, HasSubstr(message));
        EXPECT_THAT(files(), IsEmpty());
    }
};

TEST_F(ProgramAlone, RunsUntilALinuxProgramExits) {
    const tb::Outcome outcome = alone(LINUX_PROGRAMS "hello", {"--", "a"});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_THAT(file("console.txt"), HasSubstr("/hello with 1 arguments: [a]\n"));
    EXPECT_EQ(report()["end"], "the program ended");
    EXPECT_EQ(report()["cpu"], "arm");
    EXPECT_EQ(report()["scenario"], "");
    EXPECT_TRUE(report()["passed"]);
    EXPECT_THAT(outcome.out, HasSubstr("hello: the program ended; 0.1"));
    EXPECT_THAT(outcome.out, Not(HasSubstr("expectations")));
}

TEST_F(ProgramAlone, RunsUntilItsLastPictureIsSeen) {
    const tb::Outcome outcome = alone(STANDS_STILL_ELF);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_EQ(report()["end"], "the program ended");
    EXPECT_LT(report()["simulated_s"], 0.3);
    EXPECT_GE(report()["frames"]["shown"], 5u);
    EXPECT_EQ(report()["frames"]["swapped"], 1u);
    EXPECT_THAT(files(), Contains(frame(1)));
    EXPECT_THAT(files(), Not(Contains(frame(2)))) << "it is the same picture";
}

TEST_F(ProgramAlone, GetsNoAdviceOnAnUnusedDisplay) {
    for (const char* elf : {LINUX_PROGRAMS "hello", STANDS_STILL_ELF})
        EXPECT_EQ(alone(elf).err, "") << elf << " shows nothing, or just what it has drawn";
}

TEST_F(ProgramAlone, RunsAsLongAsTheCommandLineSays) {
    const tb::Outcome outcome = alone(LEDS_ELF, {"--duration", "150ms"});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_EQ(report()["end"], "duration reached");
    EXPECT_DOUBLE_EQ(report()["simulated_s"], 0.15);
}

TEST_F(ProgramAlone, RunsUntilItIsInterrupted) {
    tb::Command command;
    command.interrupt_when = [this] { return std::filesystem::exists(out / "frames"); };
    const tb::Outcome outcome = alone(KEY_INTERRUPT_ELF, {}, command);
    EXPECT_EQ(outcome.exit_code, 130);
    EXPECT_EQ(report()["end"], "interrupted");
    EXPECT_THAT(outcome.err, HasSubstr("the program was at PC 0x"));
}

TEST_F(ProgramAlone, IsWarnedOfAPictureInItsOwnMemory) {
    const tb::Outcome outcome = alone(OWN_PICTURE_ELF, {"--duration", "100ms"});
    EXPECT_EQ(outcome.exit_code, 0);
    EXPECT_THAT(outcome.err, ContainsRegex("the pixel buffer at 0x10000... is in the DDR3 memory"));
    EXPECT_THAT(outcome.err, Not(HasSubstr("did not swap")));
}

TEST_F(ProgramAlone, GetsNoAdviceOnAPictureWithoutFrames) {
    const tb::Outcome outcome =
        alone(KEEPS_DATA_ELF, {"--duration", "100ms", "--fpga-memory", "bridge"});
    EXPECT_EQ(outcome.exit_code, 0);
    EXPECT_EQ(report()["shown"]["ledr"]["lit"], "0000000101");
    EXPECT_THAT(outcome.err, Not(HasSubstr("the picture never changed")));
}

TEST_F(ProgramAlone, FailsWithTheProgram) {
    EXPECT_EQ(alone(LINUX_PROGRAMS "faults", {"--", "exit"}).exit_code, 1);
    EXPECT_EQ(report()["end"], "firmware fault");
}

TEST_F(ProgramAlone, NeedsNeitherTheWordRunNorAProcessor) {
    for (const auto& arguments : {std::vector<std::string>{LEDS_ELF},
                                  {"run", LEDS_ELF},
                                  {"run", "--elf", LEDS_ELF},
                                  {"run", scenario("duration: 9s\n"), "--elf", LEDS_ELF}}) {
        std::vector<std::string> all = arguments;
        all.insert(all.end(), {"--out", out.string(), "--duration", "1ms"});
        EXPECT_EQ(de1sim(all).exit_code, 0) << arguments.back();
        EXPECT_EQ(report()["program"]["elf"], LEDS_ELF);
    }
}

TEST_F(ProgramAlone, IsRefusedTwiceOrForTheOtherProcessor) {
    refused(alone(LEDS_ELF, {"--elf", LEDS_ELF}), "--elf: and a program in place of the scenario");
    refused(alone(LEDS_ELF, {"--cpu", "native"}), "--elf: is for --cpu arm");
    refused(alone("nothing.elf"), "nothing.elf: is not there");
    refused(alone("nothing"),
            "expected run, test, live, build, check, link, check-board, compare or merge, got "
            "\"nothing\"");
    folder.put("cut.elf", "\177ELF");
    refused(alone(folder / "cut.elf"), "cut.elf: not an ELF file");
}

class ProgramOfAScenario : public tb::CommandLine {
protected:
    void SetUp() override { std::filesystem::copy_file(LEDS_ELF, folder / "leds.elf"); }
    static constexpr const char* PLAY =
        "steps:\n  - hold: {switch: 3}\n  - expect-leds: {equals: 8, timeout: 40ms}\n";
};

TEST_F(ProgramOfAScenario, LiesRelativeToIt) {
    EXPECT_EQ(play(scenario(std::string{"program: leds.elf\n"} + PLAY)).exit_code, 0);
    EXPECT_EQ(report()["program"]["elf"], (folder / "leds.elf").string());
}

TEST_F(ProgramOfAScenario, GivesWayToTheCommandLines) {
    scenario(std::string{"program: none.elf\n"} + PLAY);
    EXPECT_EQ(play("s.yaml").exit_code, 2);
    EXPECT_EQ(play("s.yaml", {"--elf", LEDS_ELF}).exit_code, 0);
    EXPECT_EQ(report()["program"]["elf"], LEDS_ELF);
    EXPECT_EQ(play("s.yaml", {"--cpu", "native", "--duration", "1ms"}).exit_code, 1);
    EXPECT_EQ(report()["cpu"], "native");
}

}  // namespace
