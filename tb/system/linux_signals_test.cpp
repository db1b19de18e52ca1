// linux_signals_test.cpp - ^C and its kind at the terminal of a Linux program, and send-signal.
#include <gmock/gmock.h>

#include "tb/system/cli.h"

namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;
using ::testing::StartsWith;

class TypedSignal : public tb::CommandLine {
protected:
    // Types `text` 20 ms after the program has begun; it has to print `then`, if anything.
    tb::Outcome run(const std::string& how, const std::string& text,
                    const std::string& then = "") const {
        const std::string wait = then.empty() ? "" : "  - wait-serial: \"" + then + "\"\n";
        return play(
            scenario("steps:\n  - wait-serial: running\n  - delay: 20ms\n"
                     "  - type-serial: \"" +
                     text + "\"\n" + wait + "  - delay: 50ms\n"),
            {"--elf", LINUX_PROGRAMS "interrupted", "--frames", "none", "--quiet", "--", how});
    }
    std::string console() const { return file("console.txt"); }
};

TEST_F(TypedSignal, ComesIntoALoopAndLeavesItsRegisters) {
    const tb::Outcome outcome = run("computes", "\\x03", "caught");
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_EQ(console(), "running\n^Ccaught 2, right\n");
    EXPECT_NEAR(report()["expectations"][1]["time_s"].get<double>() -
                    report()["expectations"][0]["time_s"].get<double>(),
                0.021, 0.0005)
        << "when the character has come";
}

TEST_F(TypedSignal, EndsAReadAndDropsWhatWasTypedBefore) {
    EXPECT_EQ(run("reads", "ab\\x03", "caught").exit_code, 0);
    EXPECT_EQ(console(), "running\n^Ccaught 2, read -1: Interrupted system call\n");
}

TEST_F(TypedSignal, RestartsAReadWithSaRestart) {
    EXPECT_EQ(run("reads-on", "ab\\x03cd\\n", "caught").exit_code, 0);
    EXPECT_EQ(console(), "running\n^Ccd\ncaught 2, read 3: a line\n");
}

TEST_F(TypedSignal, EndsASleepAndReportsWhatWasLeft) {
    EXPECT_EQ(run("sleeps", "\\x03", "caught").exit_code, 0);
    EXPECT_EQ(console(), "running\n^Ccaught 2, -1: Interrupted system call, 979 ms left\n");
}

TEST_F(TypedSignal, WaitsUntilTheProgramLetsItIn) {
    EXPECT_EQ(run("waits", "\\x03", "caught").exit_code, 0);
    EXPECT_EQ(console(),
              "running\n^Ccaught 0 before, 2 then, -1: Interrupted system call, blocked again\n");
}

TEST_F(TypedSignal, IsACharacterWhereTheTerminalHasNoSignals) {
    EXPECT_EQ(run("takes", "\\x03\\n", "read").exit_code, 0);
    EXPECT_THAT(console(), HasSubstr("read 2, the first is 3\n"));
}

// A person ends the program so: that is no fault.
TEST_F(TypedSignal, EndsAProgramThatHasNoHandler) {
    for (const auto& [key, code, name] :
         {std::tuple{"\\x03", 130, "SIGINT: ^C"}, {"\\x1c", 131, "SIGQUIT: ^\\"}}) {
        EXPECT_EQ(run("", key).exit_code, 0);
        EXPECT_EQ(report()["program"]["exit_code"], code);
        EXPECT_THAT(report()["faults"], IsEmpty());
        ASSERT_THAT(report()["log"]["first"], SizeIs(1));
        EXPECT_THAT(report()["log"]["first"][0].get<std::string>(),
                    StartsWith(std::string{"the program was ended by "} + name));
    }
}

TEST_F(TypedSignal, StopsAProgramForWhichThereIsNoShell) {
    EXPECT_EQ(run("", "\\x1a\\x03").exit_code, 0);
    EXPECT_EQ(report()["program"]["exit_code"], nullptr);
    EXPECT_EQ(report()["program"]["at"]["waiting_for"], "SIGCONT, because it is stopped");
    EXPECT_THAT(report()["log"]["first"][0].get<std::string>(),
                StartsWith("the program was stopped by SIGTSTP: ^Z was typed"));
}

class SentSignal : public tb::CommandLine {
protected:
    // 20 ms after the program has begun.
    tb::Outcome run(const std::string& how, const std::string& step,
                    std::vector<std::string> options = {"--elf", LINUX_PROGRAMS "interrupted",
                                                        "--frames", "none", "--quiet"}) const {
        options.insert(options.end(), {"--", how});
        return play(scenario("steps:\n  - wait-serial: running\n  - delay: 20ms\n  - " + step +
                             "\n  - delay: 50ms\n"),
                    options);
    }
    std::string console() const { return file("console.txt"); }
    std::string logged() const { return report()["log"]["first"][0].get<std::string>(); }
};

TEST_F(SentSignal, ComesIntoALoopAtItsTime) {
    const tb::Outcome outcome = run("computes", "send-signal: SIGINT\n  - wait-serial: caught");
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_EQ(console(), "running\ncaught 2, right\n");
    EXPECT_NEAR(report()["expectations"][1]["time_s"].get<double>() -
                    report()["expectations"][0]["time_s"].get<double>(),
                0.02, 0.0005);
}

TEST_F(SentSignal, WakesAProgramThatWaitsAndComesFromNoProcess) {
    EXPECT_EQ(run("is-told", "send-signal: SIGUSR1").exit_code, 0);
    EXPECT_EQ(console(), "running\ncaught 10, code 0, from 0\n");
}

TEST_F(SentSignal, GoesToAProcessByItsNumber) {
    EXPECT_EQ(run("has-a-child", "send-signal: {name: SIGTERM, process: 102}").exit_code, 0);
    EXPECT_EQ(console(), "running\ncaught 0, the child's end: 15\n");
}

TEST_F(SentSignal, EndsAProgramWithoutAFault) {
    EXPECT_EQ(run("", "send-signal: SIGTERM").exit_code, 0);
    EXPECT_EQ(report()["program"]["exit_code"], 143);
    EXPECT_THAT(report()["faults"], IsEmpty());
    EXPECT_THAT(logged(), StartsWith("the program was ended by SIGTERM: it was sent from outside"));
}

TEST_F(SentSignal, LetsAStoppedProgramGoOn) {
    EXPECT_EQ(run("computes",
                  "send-signal: SIGSTOP\n  - delay: 20ms\n  - send-signal: SIGINT\n"
                  "  - delay: 20ms\n  - send-signal: SIGCONT\n"
                  "  - wait-serial: caught")
                  .exit_code,
              0);
    EXPECT_NEAR(report()["expectations"][1]["time_s"].get<double>() -
                    report()["expectations"][0]["time_s"].get<double>(),
                0.06, 0.0005);
}

TEST_F(SentSignal, ToNobodyIsALineOfTheLog) {
    EXPECT_EQ(run("is-told", "send-signal: {name: SIGHUP, process: 7}").exit_code, 0);
    EXPECT_THAT(logged(), StartsWith("SIGHUP was sent to process 7, which is not there, at "));
    EXPECT_EQ(
        run("is-told", "send-signal: SIGUSR1\n  - delay: 1ms\n  - send-signal: SIGHUP").exit_code,
        0);
    EXPECT_THAT(logged(), StartsWith("SIGHUP was sent to process 101, which has ended, at "));
}

TEST_F(SentSignal, IsRefusedWithoutALinuxProgram) {
    const std::string lines = "steps:\n  - delay: 1ms\n  - send-signal: SIGHUP\n";
    EXPECT_EQ(play(scenario(lines)).exit_code, 2);
    const tb::Outcome bare = play(scenario(lines), {"--elf", LEDS_ELF});
    EXPECT_EQ(bare.exit_code, 2);
    EXPECT_THAT(bare.err, HasSubstr("s.yaml:5:5: expected a Linux program that gets the signal "
                                    "(--elf), got one without Linux\n"));
}

}  // namespace
