// linux_calls_test.cpp - a program that makes many system calls prints what it does on Linux.
//
// The reference is the same program under qemu-arm, which hands the calls to this machine's Linux.
#include <gmock/gmock.h>

#include "tb/system/cli.h"

namespace {

using ::testing::IsEmpty;

class LinuxCalls : public tb::CommandLine {
protected:
    void run(const std::string& name, std::vector<std::string> words) const {
        words.insert(words.begin(),
                     {"--elf", LINUX_PROGRAMS + name, "--frames", "none", "--quiet", "--"});
        const tb::Outcome outcome = play(scenario("duration: 500ms\n"), words);
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

}  // namespace
