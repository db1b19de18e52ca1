// cli_gdb_test.cpp - de1sim --gdb, driven by the real gdb-multiarch in batch mode.
#include <gmock/gmock.h>

#include <regex>

#include "tb/system/gdb_session.h"

namespace {

using ::testing::AllOf;
using ::testing::ContainsRegex;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::SizeIs;
using ::testing::StartsWith;

using tb::Gdb;

// The entry is the dynamic linker's; main is where it has been moved to.
TEST_F(Gdb, StopsInADynamicallyLinkedProgram) {
    start(LINUX_PROGRAMS "hello_pie", "duration: 50ms\n");
    EXPECT_THAT(gdb({"break main", "continue", "info registers pc"}),
                AllOf(HasSubstr("Breakpoint 1, main ("), HasSubstr("<main(int, char**)>")));
    EXPECT_EQ(end().exit_code, 0);
}

// ---- Linux: threads and processes ---------------------------------------------------------------

// The program cancels a thread in pause(), then one that computes.
TEST_F(Gdb, ListsTheThreadsOfALinuxProgramAndTheirCallers) {
    start(LINUX_PROGRAMS "threads", "duration: 100ms\n", {"--", "cancels"});
    const std::string text =
        gdb({"break pthread_cancel", "continue", "info threads", "thread 2", "backtrace",
             "thread 1", "backtrace", "continue", "info threads", "thread 3", "backtrace"});
    EXPECT_THAT(text,
                ContainsRegex("Thread 101 \"threads\" \\(runs\\) +0x[0-9a-f]+ in pthread_cancel"));
    EXPECT_THAT(text, ContainsRegex("Thread 102 \"threads\" \\(waits for a signal\\).* in "));
    EXPECT_THAT(text, ContainsRegex("#[0-9]+ .* in forever \\(unused="));
    EXPECT_THAT(text, ContainsRegex("#1 .* in cancels \\(\\) at "));
    EXPECT_THAT(text, ContainsRegex("Thread 103 \"threads\" \\(waits for its turn\\).*busy \\("));
    EXPECT_THAT(text, ContainsRegex("#0 .*busy \\(unused="));
    end();
}

TEST_F(Gdb, AStepEndsInTheThreadThatIsStepped) {
    start(LINUX_PROGRAMS "threads", "duration: 100ms\n", {"--", "keeps"});
    EXPECT_THAT(gdb({"tbreak sched_yield", "continue", "stepi 8", "print $_thread", "next",
                     "print $_thread"}),
                AllOf(HasSubstr("$1 = 2\n"), HasSubstr("$2 = 2\n"), Not(HasSubstr("SIGTRAP"))));
    end();
}

// Others come to the place where the call that thread 4 steps over returns to.
TEST_F(Gdb, AStepOverACallIsOneWhereOtherThreadsCallToo) {
    start(LINUX_PROGRAMS "threads", "duration: 100ms\n", {"--", "keeps"});
    EXPECT_THAT(gdb({"tbreak compute", "continue", "tbreak threads.c:187 thread 4", "continue",
                     "next", "print $_thread", "info line"}),
                AllOf(HasSubstr("$1 = 4\n"), HasSubstr("Line 188 of "), Not(HasSubstr("SIGTRAP"))));
    end();
}

TEST_F(Gdb, StopsBeforeASignalEndsTheProgram) {
    start(LINUX_PROGRAMS "faults", "duration: 100ms\n", {"--", "segv"});
    EXPECT_THAT(gdb({"continue", "backtrace", "continue"}),
                AllOf(HasSubstr("Program received signal SIGSEGV"),
                      ContainsRegex("#0 .* in write_to_nowhere \\(\\) at .*#1 .* in main \\("),
                      HasSubstr("exited with code 01")));
    EXPECT_EQ(end().exit_code, 1);
}

TEST_F(Gdb, StopsWhereThreadsWaitForEachOther) {
    start(LINUX_PROGRAMS "threads", "duration: 100ms\n", {"--", "deadlocks"});
    EXPECT_THAT(gdb({"continue", "thread apply all backtrace", "continue"}),
                AllOf(HasSubstr("received signal SIGABRT"),
                      ContainsRegex("waits for the mutex at 0x[0-9A-F]+ that thread 101 has\\)"),
                      HasSubstr(" in locks (unused="), HasSubstr(" in deadlocks ("),
                      HasSubstr("exited with code 01")));
    EXPECT_EQ(end().exit_code, 1);
}

TEST_F(Gdb, ReadsTheMemoryOfEachProcess) {
    start(LINUX_PROGRAMS "processes", "duration: 100ms\n", {"--", "forks"});
    EXPECT_THAT(gdb({"break exit", "continue", "print value", "info threads", "thread 1",
                     "print value", "set var value = 7", "continue", "print value"}),
                AllOf(HasSubstr("$1 = 5\n"), HasSubstr("(process 102, runs)"),
                      HasSubstr("$2 = 1\n"), HasSubstr("$3 = 7\n")));
    EXPECT_EQ(end().exit_code, 0) << said();
    EXPECT_THAT(file("console.txt"), HasSubstr("parent: 7, waited"));
}

TEST_F(Gdb, CtrlCStopsALinuxProgramThatWaits) {
    start(LINUX_PROGRAMS "asks", "duration: 100s\n");
    EXPECT_THAT(gdb({"continue", "info threads", "backtrace", "kill"},
                    [this] { return said().find(" 1.00 s of") != said().npos; }),
                AllOf(HasSubstr("Program received signal SIGINT"),
                      HasSubstr("(waits for standard input)"), HasSubstr(" in read (")));
    EXPECT_EQ(end().exit_code, 130) << said();
}

// ---- Linux: kernel modules ----------------------------------------------------------------------

class GdbOfModules : public Gdb {
protected:
    void link(const std::string& made, const std::vector<std::string>& files) const {
        folder.put("doubles.c", R"(
#include <linux/module.h>
static __attribute__((noinline)) int doubled(int value)
{
    int twice = 2 * value;
    pr_info("%d\n", twice);
    return twice;
}
static int __init begin(void) { return doubled(21) == 42 ? 0 : -EINVAL; }
static void __exit end(void) {}
module_init(begin);
module_exit(end);
MODULE_LICENSE("GPL");
)");
        folder.put("main.c", "int main(void) { return 0; }\n");
        std::vector<std::string> words{"link", "-o", (folder / made).string()};
        for (const std::string& name : files) words.push_back((folder / name).string());
        words.insert(words.end(), {"--", "-Og"});
        const tb::Outcome outcome = de1sim(words);
        ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    }
    // Loads the names by these commands and stops in the module's function.
    void expect_names_after(std::vector<std::string> commands) {
        for (const char* line : {"tbreak doubled", "continue", "next", "next", "info locals",
                                 "backtrace", "info threads", "continue"})
            commands.push_back(line);
        EXPECT_THAT(gdb(commands),
                    AllOf(ContainsRegex("doubled \\(value=(value@entry=)?21\\) at "),
                          HasSubstr("twice = 42\n"), ContainsRegex("#1 .* in begin \\(\\) at "),
                          HasSubstr("\"[doubles]\" (runs)"), HasSubstr("exited normally")));
        EXPECT_EQ(end().exit_code, 0) << said();
    }
};

TEST_F(GdbOfModules, KnowsAFileByItsFixedAddresses) {
    link("doubles.ko", {"doubles.c"});
    const std::string module = (folder / "doubles.ko").string();
    start(LINUX_PROGRAMS "hello", "duration: 100ms\n", {"--module", module});
    expect_names_after({"add-symbol-file " + module});
}

TEST_F(GdbOfModules, ReadsTheNamesOfWhatAProgramBrings) {
    link("main.elf", {"doubles.c", "main.c"});
    start((folder / "main.elf").string(), "duration: 100ms\n");
    const std::string names = (folder / "names.gdb").string();
    expect_names_after({"pipe monitor modules | cat > " + names, "source " + names});
    EXPECT_THAT(folder.get("names.gdb"), StartsWith("add-symbol-file /proc/"));
}

// ---- Bare metal ---------------------------------------------------------------------------------

TEST_F(Gdb, StandsAtTheEntryBeforeTheFirstInstruction) {
    start(SUMS_ELF, "duration: 1ms\n");
    EXPECT_THAT(gdb({"info registers pc sp cpsr", "monitor time"}),
                AllOf(HasSubstr("0x0 <_start>"), HasSubstr("0x3ffffff8"), HasSubstr("0x1d3"),
                      HasSubstr("0.000000 ms, 0 instructions")));
    EXPECT_EQ(end().exit_code, 0);
}

TEST_F(Gdb, StopsAtABreakpointAndKnowsWhoCalled) {
    start(SUMS_ELF, "duration: 1ms\n");
    EXPECT_THAT(
        gdb({"break square", "continue", "continue", "print x", "backtrace", "finish"}),
        AllOf(HasSubstr("Breakpoint 1, square (x=x@entry=2)"), HasSubstr("$1 = 2"),
              HasSubstr("#1  0x"), HasSubstr("in add_squares (count=count@entry=4)"),
              HasSubstr("#2  0x"), HasSubstr("in main ()"), HasSubstr("Value returned is $2 = 4")));
    end();
}

TEST_F(Gdb, StepsByLineAndByInstruction) {
    start(SUMS_ELF, "duration: 1ms\n");
    const std::string text = gdb({"tbreak add_squares", "continue", "tbreak sums.c:17", "continue",
                                  "next", "step", "step", "print/x $pc", "stepi", "print/x $pc"});
    EXPECT_THAT(text, AllOf(HasSubstr("\n15\t"), HasSubstr("square (x=x@entry=2)")));
    std::smatch at;
    ASSERT_TRUE(std::regex_search(text, at, std::regex{"\\$1 = 0x(\\w+)[^]*\\$2 = 0x(\\w+)"}));
    EXPECT_EQ(std::stoul(at[2], nullptr, 16), std::stoul(at[1], nullptr, 16) + 4);
    end();
}

TEST_F(Gdb, StopsAtWritesAndReadsOfAVariable) {
    start(SUMS_ELF, "duration: 1ms\n");
    const std::string text = gdb({"watch total", "continue", "continue", "delete", "rwatch total",
                                  "continue", "delete", "awatch rounds", "continue"});
    EXPECT_THAT(text, AllOf(HasSubstr("Old value = 0\nNew value = 1\n"),
                            HasSubstr("Old value = 1\nNew value = 5\n"),
                            HasSubstr("Hardware read watchpoint 2: total\n\nValue = 5"),
                            HasSubstr("Hardware access (read/write) watchpoint 3: rounds")));
    end();
}

TEST_F(Gdb, SeesAReadOfALoopThatHasRunBefore) {
    start(SUMS_ELF, "duration: 1ms\n");
    EXPECT_THAT(gdb({"break square", "continue", "continue", "delete", "rwatch total", "continue"}),
                HasSubstr("Hardware read watchpoint 2: total\n\nValue = 1\n"));
    end();
}

TEST_F(Gdb, StopsWhereADeviceIsWrittenBeforeItIs) {
    start(SUMS_ELF, "duration: 1ms\n");
    EXPECT_THAT(gdb({"watch *(unsigned*)0xFF200000", "continue", "backtrace"}),
                AllOf(HasSubstr("Old value = 0\nNew value = 30\n"), HasSubstr("#0  "),
                      HasSubstr(" in main ()")));
    end();
}

TEST_F(Gdb, ReadsAndWritesRegistersAndMemory) {
    start(SUMS_ELF, "duration: 1ms\n");
    EXPECT_THAT(
        gdb({"tbreak add_squares", "continue", "set var total = 100", "set $r0 = 2", "print $r0",
             "set $d31 = 2.5", "print $d31", "print/x (long long)$s31", "finish", "print total",
             "x/2xb &total", "set var *(char*)&total = 0x7f", "print/x total", "tbreak sums.c:25",
             "continue", "print mean", "print/x $fpscr"}),
        AllOf(HasSubstr("$1 = 2\n"), HasSubstr("$2 = 2.5\n"), HasSubstr("$4 = 105\n"),
              HasSubstr("0x69\t0x00"), HasSubstr("$5 = 0x7f\n"), HasSubstr("$6 = 31.75\n")));
    end();
}

TEST_F(Gdb, ReadsAndWritesDevicesThroughTheBus) {
    start(SUMS_ELF, "steps:\n  - expect-leds: {equals: \"1010101010\", timeout: 2s}\n");
    EXPECT_THAT(gdb({"tbreak sums.c:26", "continue", "x/1xw 0xFF200000", "x/1xw 0xFF202040",
                     "x/1xw 0xFFFEC104", "x/1xw 0xFFC00000",
                     "set var *(unsigned*)0xFF200000 = 0x2AA", "x/1xw 0xFF200000"}),
                AllOf(HasSubstr("0xff200000:\t0x0000001e"), HasSubstr("0xff202040:\t0x44453153"),
                      HasSubstr("0xfffec104:\t0x00000000"),
                      HasSubstr("Cannot access memory at address 0xffc00000"),
                      HasSubstr("0xff200000:\t0x000002aa")));
    EXPECT_EQ(end().exit_code, 0) << said();
    EXPECT_EQ(report()["program"]["aborts"], 0u) << "the debugger's access is not the program's";
}

TEST_F(Gdb, AStepOverADeviceAccessIsOneInstruction) {
    start(SUMS_ELF, "duration: 1ms\n");
    std::vector<std::string> commands{"tbreak sums.c:24", "continue", "set $begin = $pc"};
    for (unsigned i = 0; i < 4; ++i) {
        commands.push_back("stepi");
        commands.push_back("print $pc - $begin");
    }
    commands.push_back("x/1xw 0xFF200000");
    EXPECT_THAT(gdb(commands),
                AllOf(HasSubstr("$1 = 4\n"), HasSubstr("$2 = 8\n"), HasSubstr("$3 = 12\n"),
                      HasSubstr("$4 = 16\n"), HasSubstr("0xff200000:\t0x0000001e")));
    end();
}

// The debugger itself makes ID 73 pending, in the distributor's ICDISPR2.
TEST_F(Gdb, AStepHoldsInterruptsAndContinueTakesThem) {
    start(KEY_INTERRUPT_ELF, "duration: 100ms\n");
    EXPECT_THAT(gdb({"tbreak key_interrupt.c:23", "continue", "set $begin = $pc",
                     "set var *(unsigned*)0xFFFED208 = 0x200", "stepi", "print $pc - $begin",
                     "tbreak on_irq", "continue", "print/x $cpsr & 31"}),
                AllOf(HasSubstr("$1 = 4\n"), HasSubstr("on_irq () at"), HasSubstr("$2 = 0x12\n")));
    end();
}

TEST_F(Gdb, CtrlCStopsABusyProgramAndASleepingOne) {
    for (const char* program : {LEDS_ELF, SUMS_ELF}) {
        std::filesystem::remove(errors);
        port.clear();
        start(program, "duration: 100s\n");
        const std::string text = gdb({"continue", "backtrace", "monitor time", "kill"},
                                     [this] { return said().find(" 1.00 s of") != said().npos; });
        EXPECT_THAT(text,
                    AllOf(HasSubstr("Program received signal SIGINT"), HasSubstr("main () at "),
                          HasSubstr(" ms, "), HasSubstr("killed]")));
        EXPECT_EQ(end().exit_code, 130) << said();
    }
}

TEST_F(Gdb, TimeStandsStillWithTheProgram) {
    start(SUMS_ELF, "duration: 1ms\n");
    const std::string text =
        gdb({"tbreak sums.c:26", "continue", "monitor time", "shell sleep 1", "monitor time"});
    std::smatch at;
    ASSERT_TRUE(std::regex_search(
        text, at, std::regex{"([0-9.]+ ms, \\d+ instructions)\n([0-9.]+ ms, \\d+ instructions)"}))
        << text;
    EXPECT_EQ(at[1], at[2]);
    end();
}

TEST_F(Gdb, RunsToTheEndAndHearsItsExitCode) {
    start(SUMS_ELF, "steps:\n  - expect-leds: {equals: \"0000011110\", timeout: 1s}\n");
    EXPECT_THAT(gdb({"continue"}), HasSubstr("exited normally"));
    EXPECT_EQ(end().exit_code, 0) << said();
    port.clear();
    std::filesystem::remove(errors);
    start(SUMS_ELF, "steps:\n  - expect-leds: \"1111111111\"\n");
    EXPECT_THAT(gdb({"continue"}), HasSubstr("exited with code 01"));
    EXPECT_EQ(end().exit_code, 1);
}

TEST_F(Gdb, SeesAnAbortThatTheProgramHasNoVectorFor) {
    start(NO_VECTORS_ELF, "duration: 1s\n");
    EXPECT_THAT(gdb({"continue", "backtrace", "continue"}),
                AllOf(HasSubstr("Program received signal SIGSEGV"),
                      HasSubstr("in main_without_vectors ()"), HasSubstr("exited with code 01")));
    EXPECT_EQ(end().exit_code, 1);
}

TEST_F(Gdb, ARunWithoutCommandsIsUnchanged) {
    const std::string steps = "duration: 100ms\nsteps:\n  - press: {keypad: \"1\", for: 30ms}\n";
    start(COLLIDE_ELF, steps);
    gdb({"detach"});
    EXPECT_EQ(end().exit_code, 0) << said();
    nlohmann::json with = report();
    play(scenario(steps), {"--frames", "none", "--cpu", "arm", "--elf", COLLIDE_ELF});
    nlohmann::json without = report();
    for (nlohmann::json* one : {&with, &without}) one->erase("wall_s"), one->erase("speed");
    EXPECT_GT(with["program"]["instructions"], 100'000u);
    EXPECT_EQ(with["program"], without["program"]);
    EXPECT_EQ(with["bus"], without["bus"]);
}

TEST_F(Gdb, ABrokenConnectionLetsTheRunContinue) {
    start(SUMS_ELF, "duration: 100s\n");
    const std::string first = gdb({"break square", "continue", "shell kill -9 $PPID"});
    EXPECT_THAT(first, HasSubstr("Breakpoint 1"));
    EXPECT_THAT(gdb({"monitor time", "print total", "kill"}), HasSubstr("$1 = 30"));
    EXPECT_EQ(end().exit_code, 130);
}

TEST_F(Gdb, APortInUseIsOneLine) {
    start(SUMS_ELF, "duration: 1ms\n");
    const std::string scene = (folder / scenario("duration: 1ms\n", "b.yaml")).string();
    const tb::Outcome second = de1sim({"run", scene, "--cpu", "arm", "--elf", SUMS_ELF, "--gdb",
                                       port, "--out", (folder / "b").string()});
    EXPECT_EQ(second.exit_code, 2);
    EXPECT_THAT(tb::lines_of(second.err), SizeIs(1));
    EXPECT_THAT(second.err, HasSubstr("127.0.0.1:" + port + ": Address already in use"));
    EXPECT_FALSE(std::filesystem::exists(folder / "b"));
    gdb({"kill"});
    end();
}

TEST_F(Gdb, RefusesPortsThatAreNone) {
    scenario("duration: 1s\n");
    for (const char* given : {"-1", "65536", "", "x", "1e3"})
        EXPECT_EQ(play("s.yaml", {"--cpu", "arm", "--elf", SUMS_ELF, "--gdb", given}).exit_code, 2)
            << given;
    EXPECT_THAT(play("s.yaml", {"--gdb", "0"}).err, HasSubstr("--gdb: is for --cpu arm"));
}

}  // namespace
