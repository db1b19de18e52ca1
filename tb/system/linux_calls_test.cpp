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
TEST_F(LinuxCalls, InterruptALoopOfOneInstruction) {
    EXPECT_EQ(play(scenario("duration: 2s\n"),
                   {"--elf", LINUX_PROGRAMS "itimers", "--quiet", "--", "spins"})
                  .exit_code,
              1);
    EXPECT_THAT(report()["faults"][0].get<std::string>(),
                StartsWith("the program ended with exit code 14 "));
}
TEST_F(LinuxCalls, TalkByPosixMessageQueues) {
    prints_as_on_linux("mqueue",
                       "not there: No such file or directory\n"
                       "a folder: Permission denied\n"
                       "a slash: No such file or directory\n"
                       "a long name: File name too long\n"
                       "no messages: Invalid argument\n"
                       "too many: Invalid argument\n"
                       "no bytes: Invalid argument\n"
                       "too long: Invalid argument\n"
                       "no attributes: Bad address\n"
                       "unlink none: No such file or directory\n"
                       "open: done\n"
                       "another: File exists\n"
                       "receive: Bad file descriptor\n"
                       "nine bytes: Message too long\n"
                       "priority 32768: Invalid argument\n"
                       "from nowhere: Bad address\n"
                       "to no queue: Bad file descriptor\n"
                       "to no file: Bad file descriptor\n"
                       "10^9 ns: Invalid argument\n"
                       "first: done\n"
                       "second: done\n"
                       "third: Resource temporarily unavailable\n"
                       "other flags: Invalid argument\n"
                       "flags 800, 2 of 2, 8 bytes\n"
                       "before: 800, now 1\n"
                       "it was before: Connection timed out\n"
                       "read only: Bad file descriptor\n"
                       "seven bytes: Message too long\n"
                       "unlink: done\n"
                       "it lives on: \"\" 32767\n"
                       "it lives on: \"12345678\" 1\n"
                       "gone: No such file or directory\n"
                       "10 messages of 8192 bytes\n"
                       "none: Resource temporarily unavailable\n"
                       "empty: 4\n"
                       "b: done\n"
                       "a: done\n"
                       "c: done\n"
                       "d: done\n"
                       "some: 5\n"
                       "QSIZE:4        \n"
                       "9: \"d\" 9\n"
                       "2: \"b\" 2\n"
                       "2 again: \"c\" 2\n"
                       "1: \"a\" 1\n"
                       "full: 1\n"
                       "one more: Resource temporarily unavailable\n"
                       "they wait: 4\n"
                       "first: \"first\" 0\n"
                       "second: \"secon\" 0\n"
                       "third: \"third\" 0\n"
                       "full: done\n"
                       "in their order: \"0\" 5\n"
                       "in their order: \"first\" 0\n"
                       "in their order: \"secon\" 0\n"
                       "in their order: \"third\" 0\n"
                       "nothing comes: Connection timed out\n"
                       "full: done\n"
                       "nobody takes: Connection timed out\n"
                       "the only one: \"0\" 5\n"
                       "interrupted: Interrupted system call\n");
}
// QEMU 7 prints the same; QEMU 10 reads struct msqid_ds wrongly.
TEST_F(LinuxCalls, TalkByMessageQueuesOfSystemV) {
    prints("messages", {},
           "not there: No such file or directory\n"
           "get: done\n"
           "the same: 1\n"
           "another: File exists\n"
           "type 0: Invalid argument\n"
           "too long: Invalid argument\n"
           "below 0: Invalid argument\n"
           "from nowhere: Bad address\n"
           "below 0: Invalid argument\n"
           "none: No message of desired type\n"
           "another command: Invalid argument\n"
           "one: done\n"
           "four bytes: Argument list too long\n"
           "cut: 5 \"1234\"\n"
           "a: done\n"
           "b: done\n"
           "c: done\n"
           "d: done\n"
           "e: done\n"
           "f: done\n"
           "g: done\n"
           "7 messages of 6 bytes, at most 16384, mode 640, key 1\n"
           "sent by this one: 1, received by this one: 1\n"
           "of 2: 2 \"c\"\n"
           "up to 2: 1 \"b\"\n"
           "but not 3: 1 \"d\"\n"
           "up to 1: No message of desired type\n"
           "any: 3 \"a\"\n"
           "up to 9: 3 \"e\"\n"
           "of 4: No message of desired type\n"
           "up to all: 3 \"\"\n"
           "any: 9 \"f\"\n"
           "none: No message of desired type\n"
           "5 to the first that wants it\n"
           "waits for 0: 5 \"x\"\n"
           "2 to the first that wants it\n"
           "waits for 2: 2 \"x\"\n"
           "2 to the first that wants it\n"
           "waits for -3: 2 \"x\"\n"
           "3 to the first that wants it\n"
           "waits for 2: 2 \"y\"\n"
           "left: 3 \"x\"\n"
           "4000 bytes: done\n"
           "4000 bytes: done\n"
           "4000 bytes: done\n"
           "4000 bytes: done\n"
           "full: Resource temporarily unavailable\n"
           "but for 384: done\n"
           "one: 1 \"\"\n"
           "one: 1 \"\"\n"
           "one: 1 \"\"\n"
           "one: 1 \"\"\n"
           "one: 1 \"\"\n"
           "the first: 10 \"\"\n"
           "the second: 11 \"\"\n"
           "a smaller one: done\n"
           "full: Resource temporarily unavailable\n"
           "waits for 2: Identifier removed\n"
           "the sender: Identifier removed\n"
           "remove: Invalid argument\n"
           "not there: No such file or directory\n"
           "from a child: 7 \"child\"\n"
           "interrupted: Interrupted system call\n");
}
// qemu-arm has no mq_notify.
TEST_F(LinuxCalls, GetOneNoticeOfAMessage) {
    prints("mqueue", {"notices"},
           "tell me: done\n"
           "twice: Device or resource busy\n"
           "QSIZE:0          NOTIFY:0     SIGNO:34    N\n"
           "a child: Device or resource busy\n"
           "from a child: done\n"
           "signal 1 code -3 value 6, own 0\n"
           "again: done\n"
           "not empty: done\n"
           "no signal: -1\n"
           "a: \"a\" 1\n"
           "b: \"b\" 1\n"
           "empty: done\n"
           "signal: 1\n"
           "again: done\n"
           "not any more: done\n"
           "c: \"c\" 1\n"
           "empty: done\n"
           "no signal: -1\n"
           "silently: done\n"
           "busy: Device or resource busy\n"
           "closed: done\n"
           "signal 65: Invalid argument\n"
           "notify 7: Invalid argument\n"
           "no queue: Bad file descriptor\n");
}
TEST_F(LinuxCalls, MakeMessageQueuesAsUser0Can) {
    prints("mqueue", {"apart"},
           "eleven: done\n"
           "ninety more: Too many open files\n"
           "read and write: Invalid argument\n"
           "eighty more: done\n"
           "by a thread: Function not implemented\n"
           "by a thread: Function not implemented\n");
    EXPECT_THAT(report()["log"]["first"][0].get<std::string>(),
                StartsWith("system call 278 (mq_notify with SIGEV_THREAD) is not emulated"));
}
TEST_F(LinuxCalls, LoseAMessageThatGoesNowhere) {
    prints("messages", {"apart"},
           "no queue: Invalid argument\n"
           "one: done\n"
           "to nowhere: Bad address\n"
           "lost: No message of desired type\n");
}

}  // namespace
