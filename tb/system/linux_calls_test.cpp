// linux_calls_test.cpp - a program that makes many system calls prints what it does on Linux.
//
// The reference is the same program under qemu-arm, which hands the calls to this machine's Linux.
#include <gmock/gmock.h>

#include "tb/system/cli.h"

namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::StartsWith;

class LinuxCalls : public tb::CommandLine {
protected:
    void run(const std::string& name, std::vector<std::string> words) const {
        words.insert(words.begin(),
                     {"--elf", LINUX_PROGRAMS + name, "--frames", "none", "--quiet", "--"});
        const tb::Outcome outcome = play(scenario("duration: 2s\n"), words);
        EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
        EXPECT_EQ(report()["program"]["exit_code"], 0);
    }
    // Here alone: qemu-arm does not do it as Linux does.
    void prints(const std::string& name, const std::vector<std::string>& words,
                const std::string& text) const {
        run(name, words);
        EXPECT_EQ(file("console.txt"), text);
    }
    // Here and under qemu-arm.
    void prints_as_on_linux(const std::string& name, const std::string& text,
                            const std::vector<std::string>& words = {}) const {
        prints(name, words, text);
        EXPECT_THAT(report()["log"]["first"], IsEmpty());
        tb::Command qemu;
        qemu.arguments = {QEMU_ARM, "-cpu", "cortex-a9", LINUX_PROGRAMS + name};
        qemu.arguments.insert(qemu.arguments.end(), words.begin(), words.end());
        EXPECT_EQ(tb::run_program(qemu).out, text);
    }
};

TEST_F(LinuxCalls, ReadSignalsFromAFile) {
    prints_as_on_linux("signalfd",
                       "no mask: Bad address\n"
                       "other flags: Invalid argument\n"
                       "no file: Bad file descriptor\n"
                       "another file: Invalid argument\n"
                       "below -1: Bad file descriptor\n"
                       "open: done\n"
                       "too short a read: Invalid argument\n"
                       "write: Invalid argument\n"
                       "none: Resource temporarily unavailable\n"
                       "no event: 0, 0\n"
                       "event: 1, 1\n"
                       "the own first: 12 code -6 value 0 pointer 0 own;"
                       " 10 code 0 value 0 pointer 0 own;\n"
                       "taken: 0, 0\n"
                       "the first two: 35 code -1 value 1 pointer 1 own;"
                       " 35 code -1 value 2 pointer 2 own;\n"
                       "the third: 35 code -1 value 3 pointer 3 own;\n"
                       "the same: 1\n"
                       "another mask: Resource temporarily unavailable\n"
                       "pending: 1\n"
                       "the first mask: 10 code -6 value 0 pointer 0 own;\n"
                       "the first thread: Resource temporarily unavailable\n"
                       "the thread: 12 code -6 value 0 pointer 0 own;\n"
                       "by edge: 0, 1, 0, 1\n"
                       "both: 10 code -6 value 0 pointer 0 own; 12 code -6 value 0 pointer 0 own;\n"
                       "child: 128 bytes, 17 code 1 status 3, its number: 1\n"
                       "interrupted: Interrupted system call\n");
}
TEST_F(LinuxCalls, ReadSignalsAsALongOf32BitsHasThem) {
    prints("signalfd", {"apart"},
           "too short a mask: Invalid argument\n"
           "below 0: 34 code -1 value -1 pointer ffffffffffffffff own;\n");
}
TEST_F(LinuxCalls, SendTimersSignalsAndThreads) {
    prints_as_on_linux("posix_timers",
                       "clock 10: Invalid argument\n"
                       "clock 12: Invalid argument\n"
                       "a raw clock: Operation not supported\n"
                       "a coarse clock: Operation not supported\n"
                       "no memory: Bad address\n"
                       "signal 65: Invalid argument\n"
                       "notify 3: Invalid argument\n"
                       "another's thread: Invalid argument\n"
                       "none: done\n"
                       "set: done\n"
                       "10^9 ns: Invalid argument\n"
                       "below 0: Invalid argument\n"
                       "no time: Invalid argument\n"
                       "no such timer: Invalid argument\n"
                       "get none: Invalid argument\n"
                       "overrun of none: Invalid argument\n"
                       "delete none: Invalid argument\n"
                       "delete: done\n"
                       "delete again: Invalid argument\n"
                       "not set: 0 0\n"
                       "too early: Resource temporarily unavailable\n"
                       "once: 34 code -2 value 7\n"
                       "once: overrun 0\n"
                       "not again: Resource temporarily unavailable\n"
                       "over: 0 0\n"
                       "it was before: 34 code -2 value 7\n"
                       "by the clock: 34 code -2 value 7\n"
                       "before: 1, 0\n"
                       "before: 1, 3\n"
                       "never: 0, 0\n"
                       "every 5 ms: 34 code -2 value 7\n"
                       "overrun: 1, 1\n"
                       "every 5 ms: 34 code -2 value 7\n"
                       "asked: 1\n"
                       "asked: 0 0\n"
                       "asked: 1\n"
                       "the earlier: 34 code -2 value 2\n"
                       "the later: 34 code -2 value 1\n"
                       "caught 9\n"
                       "the first: Resource temporarily unavailable\n"
                       "the thread: 34 code -2 value 3\n"
                       "a thread each: done\n"
                       "a function: 4, in another thread: 1\n"
                       "a function: 4, in another thread: 1\n"
                       "while it waits: Resource temporarily unavailable\n"
                       "while it computes: 1\n"
                       "by processor time: 34 code -2 value 5\n"
                       "while a thread computes: 1\n"
                       "by processor time: 34 code -2 value 5\n"
                       "while another computes: 0\n"
                       "while this one computes: 1\n"
                       "by its own time: 34 code -2 value 6\n"
                       "in a child: 1\n"
                       "here: 34 code -2 value 8\n");
}
TEST_F(LinuxCalls, CountWhatATimersSignalMissed) {
    prints("posix_timers", {"apart"},
           "timers 0 and 1: signal 14 of 1, value 1, overrun 9\n"
           "0.9 ms left, every 2 ms\n"
           "overrun 1\n"
           "set while it was pending: overrun 1, then 0\n"
           "the next one: 2\n"
           "in another program: 0\n"
           "deleted since: 34 code -2 value 8\n"
           "deleted: Resource temporarily unavailable\n");
}
TEST_F(LinuxCalls, SetTimersOfProcessorTime) {
    prints_as_on_linux("itimers",
                       "microseconds: Invalid argument\n"
                       "no such timer: Invalid argument\n"
                       "get no such timer: Invalid argument\n"
                       "virtual: 0 while it sleeps\n"
                       "left: 1, every 20000\n"
                       "comes: 1, from the kernel: 1\n"
                       "in a child: 0\n"
                       "before: every 20000\n"
                       "never: 0\n"
                       "once: 1, left 0 0\n"
                       "prof: 0 while it sleeps\n"
                       "left: 1, every 20000\n"
                       "comes: 1, from the kernel: 1\n"
                       "in a child: 0\n"
                       "before: every 20000\n"
                       "never: 0\n"
                       "once: 1, left 0 0\n");
}
TEST_F(LinuxCalls, CountProcessorTimeExactly) {
    run("itimers", {"exactly"});
    EXPECT_THAT(file("console.txt"), HasSubstr("left: 1, every 20000\n10 while it computes\n"));
}
TEST_F(LinuxCalls, EndByTheSignalOfATimer) {
    const tb::Outcome outcome = play(scenario("duration: 100ms\n"),
                                     {"--elf", LINUX_PROGRAMS "itimers", "--quiet", "--", "dies"});
    EXPECT_EQ(outcome.exit_code, 1);
    EXPECT_THAT(report()["faults"][0].get<std::string>(),
                StartsWith("the program was ended by SIGPROF: a timer expired, at "));
}

}  // namespace
