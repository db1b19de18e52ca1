// cli_gdb_nios_v_test.cpp - gdb-multiarch at a program for Nios V.
#include <gmock/gmock.h>

#include "tb/system/gdb_session.h"

namespace {

using ::testing::AllOf;
using ::testing::ContainsRegex;
using ::testing::HasSubstr;
using ::testing::Not;

class GdbOfNiosV : public tb::Gdb {
protected:
    void start_sums(const std::string& steps = "duration: 1ms\n") { start(NIOS_V_SUMS_ELF, steps); }
};

TEST_F(GdbOfNiosV, StandsAtTheEntryBeforeTheFirstInstruction) {
    start_sums();
    EXPECT_THAT(gdb({"info registers pc sp", "print/x $mtvec", "print/x $misa", "monitor time"}),
                AllOf(HasSubstr("0x0 <_start>"), ContainsRegex("sp +0x0"), HasSubstr("$1 = 0x0"),
                      HasSubstr("$2 = 0x40001121"), HasSubstr("0.000000 ms, 0 instructions")));
    EXPECT_EQ(end().exit_code, 0) << said();
}

TEST_F(GdbOfNiosV, StopsAtABreakpointAndKnowsWhoCalled) {
    start_sums();
    EXPECT_THAT(gdb({"break square", "continue", "continue", "print x", "backtrace", "delete",
                     "hbreak sums.c:25", "continue"}),
                AllOf(HasSubstr("Breakpoint 1, square (x=x@entry=2)"), HasSubstr("$1 = 2"),
                      HasSubstr("#1  0x"), HasSubstr("in add_squares (count=count@entry=4)"),
                      HasSubstr("#2  0x"), HasSubstr("in main ()"),
                      HasSubstr("Breakpoint 2, main () at ")));
    end();
}

TEST_F(GdbOfNiosV, StepsByLineAndByInstruction) {
    start_sums();
    EXPECT_THAT(gdb({"tbreak sums.c:17", "continue", "next", "print total", "step", "step",
                     "print/x $pc", "stepi", "print $pc - $1", "finish"}),
                AllOf(HasSubstr("$1 = 1"), HasSubstr("square (x=x@entry=2)"),
                      HasSubstr("Value returned is $4 = 4")));
    end();
}

TEST_F(GdbOfNiosV, StopsAtWritesAndReadsOfAVariable) {
    start_sums();
    EXPECT_THAT(gdb({"watch total", "continue", "continue", "delete", "rwatch total", "continue",
                     "delete", "awatch rounds", "continue"}),
                AllOf(HasSubstr("Old value = 0\nNew value = 1\n"),
                      HasSubstr("Old value = 1\nNew value = 5\n"),
                      HasSubstr("Hardware read watchpoint 2: total\n\nValue = 5"),
                      HasSubstr("Hardware access (read/write) watchpoint 3: rounds")));
    end();
}

TEST_F(GdbOfNiosV, StopsWhereADeviceIsWrittenBeforeItIs) {
    start_sums();
    EXPECT_THAT(gdb({"watch *(unsigned*)0xFF200000", "continue", "backtrace"}),
                AllOf(HasSubstr("Old value = 0\nNew value = 30\n"), HasSubstr("#0  "),
                      HasSubstr("main () at ")));
    end();
}

TEST_F(GdbOfNiosV, ReadsAndWritesRegistersAndMemory) {
    start_sums();
    EXPECT_THAT(gdb({"tbreak add_squares", "continue", "set var total = 100", "set $a0 = 2",
                     "print $x10", "set $ft11 = 2.5", "print $f31", "set $mscratch = 0x1234",
                     "print/x $mscratch", "set $fcsr = 3", "print/x $fflags", "set $mvendorid = 1",
                     "finish", "print total", "x/2xb &total"}),
                AllOf(HasSubstr("$1 = 2\n"), ContainsRegex("\\$2 = (2.5|\\{float = 2.5)"),
                      HasSubstr("$3 = 0x1234\n"), HasSubstr("$4 = 0x3\n"),
                      HasSubstr("Could not write register \"mvendorid\""), HasSubstr("$5 = 105\n"),
                      HasSubstr("0x69\t0x00")));
    end();
}

TEST_F(GdbOfNiosV, ReadsAndWritesDevicesThroughTheBus) {
    start_sums("steps:\n  - expect-leds: {equals: \"1010101010\", timeout: 2s}\n");
    EXPECT_THAT(gdb({"tbreak sums.c:26", "continue", "x/1xw 0xFF200000", "x/1xw 0xFFC00000",
                     "set var *(unsigned*)0xFF200000 = 0x2AA", "x/1xw 0xFF200000"}),
                AllOf(HasSubstr("0xff200000:\t0x0000001e"),
                      HasSubstr("Cannot access memory at address 0xffc00000"),
                      HasSubstr("0xff200000:\t0x000002aa")));
    EXPECT_EQ(end().exit_code, 0) << said();
    EXPECT_EQ(report()["program"]["aborts"], 0u) << "the debugger's access is not the program's";
}

TEST_F(GdbOfNiosV, AStepOverADeviceAccessIsOneInstruction) {
    start_sums();
    EXPECT_THAT(
        gdb({"watch *(unsigned*)0xFF200000", "continue", "delete", "set $pc = $pc - 4",
             "set $begin = $pc", "stepi", "print $pc - $begin", "stepi", "print $pc - $begin"}),
        AllOf(HasSubstr("$1 = 4\n"), HasSubstr("$2 = 8\n")));
    end();
}

// The debugger itself raises the software interrupt.
TEST_F(GdbOfNiosV, AStepHoldsInterruptsAndContinueTakesThem) {
    start_sums();
    EXPECT_THAT(
        gdb({"tbreak add_squares", "continue", "set $begin = $pc", "set $mie = 8",
             "set $mstatus = 8", "set var *(unsigned*)0xFF202110 = 1", "print/x $mip", "stepi",
             "print $pc - $begin", "tbreak on_irq", "continue", "print/x $mcause"}),
        AllOf(HasSubstr("$1 = 0x8\n"), HasSubstr("$2 = 4\n"), HasSubstr("on_irq ()"),
              HasSubstr("$3 = 0x80000003\n")));
    end();
}

TEST_F(GdbOfNiosV, CtrlCStopsASleepingProgram) {
    start_sums("duration: 100s\n");
    EXPECT_THAT(gdb({"continue", "backtrace", "monitor time", "kill"},
                    [this] { return said().find(" 1.00 s of") != said().npos; }),
                AllOf(HasSubstr("Program received signal SIGINT"), HasSubstr("main () at "),
                      HasSubstr(" ms, "), HasSubstr("killed]")));
    EXPECT_EQ(end().exit_code, 130) << said();
}

// The instruction is written by the debugger, into code that has run.
TEST_F(GdbOfNiosV, StopsAtAnEbreakThatItHasWrittenIntoMemory) {
    start_sums();
    EXPECT_THAT(gdb({"tbreak square", "continue", "set $begin = $pc", "set $was = *(unsigned*)$pc",
                     "finish", "set var *(unsigned*)$begin = 0x00100073", "continue",
                     "print $pc - $begin", "set var *(unsigned*)$begin = $was", "tbreak main",
                     "tbreak sums.c:26", "continue", "print total"}),
                AllOf(HasSubstr("Program received signal SIGTRAP"), HasSubstr("= 0\n"),
                      HasSubstr("= 30\n")));
    EXPECT_EQ(end().exit_code, 0) << said();
}

TEST_F(GdbOfNiosV, SeesATrapThatTheProgramHasNoHandlerFor) {
    start_sums();
    EXPECT_THAT(gdb({"stepi", "set $t0 = 0x40000000", "set var *(unsigned*)$pc = 0x0002a303",
                     "continue", "print/x *(unsigned*)$pc", "continue"}),
                AllOf(HasSubstr("Program received signal SIGSEGV"), HasSubstr("= 0x2a303\n"),
                      HasSubstr("exited with code 01")));
    EXPECT_EQ(end().exit_code, 1);
    EXPECT_THAT(said(), HasSubstr("access fault: load at 0x40000000"));
}

TEST_F(GdbOfNiosV, RunsToTheEndAndHearsItsExitCode) {
    start_sums("steps:\n  - expect-leds: {equals: \"0000011110\", timeout: 1s}\n");
    EXPECT_THAT(gdb({"continue"}), HasSubstr("exited normally"));
    EXPECT_EQ(end().exit_code, 0) << said();
}

TEST_F(GdbOfNiosV, ARunWithoutCommandsIsUnchanged) {
    const std::string steps = "duration: 20ms\nsteps:\n  - press: {key: 0, for: 5ms}\n";
    start_sums(steps);
    EXPECT_THAT(gdb({"detach"}), Not(HasSubstr("warning")));
    EXPECT_EQ(end().exit_code, 0) << said();
    nlohmann::json with = report();
    play(scenario(steps), {"--frames", "none", "--elf", NIOS_V_SUMS_ELF});
    const nlohmann::json without = report();
    EXPECT_GT(with["program"]["instructions"], 100u);
    EXPECT_EQ(with["program"], without["program"]);
    EXPECT_EQ(with["bus"]["writes"], without["bus"]["writes"]);
}

}  // namespace
