// linux_processes_test.cpp - processes of Linux programs, what they share, and the system's files.
#include <gmock/gmock.h>

#include "tb/system/cli.h"

namespace {

using ::testing::EndsWith;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;
using ::testing::StartsWith;

class Processes : public tb::CommandLine {
protected:
    tb::Outcome run(const std::string& what) const {
        const bool sockets = what == "udp" || what == "tcp" || what == "unix" || what == "outside";
        const std::string program = sockets ? "sockets" : "processes";
        return play(scenario("duration: 400ms\n"),
                    {"--elf", LINUX_PROGRAMS + program, "--frames", "none", "--quiet", "--", what});
    }
    std::string console() const { return file("console.txt"); }
    void prints(const std::string& what, const std::string& text) const {
        const tb::Outcome outcome = run(what);
        EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
        EXPECT_EQ(console(), text);
    }
    void prints_without_a_message(const std::string& what, const std::string& text) const {
        prints(what, text);
        EXPECT_THAT(report()["log"]["first"], IsEmpty());
    }
};

TEST_F(Processes, HaveTheirOwnMemoryAndAnExitCode) {
    prints_without_a_message("forks", "child: 5\nparent: 1, waited, exit code 3, then -1\n");
}
TEST_F(Processes, TalkByPipes) { prints_without_a_message("pipes", "HELLO, 65536, 8192, end 0\n"); }
TEST_F(Processes, KillEachOther) { prints_without_a_message("kills", "signal 15, 1 of SIGCHLD\n"); }
TEST_F(Processes, BecomeAnotherProgram) {
    prints("becomes",
           "it is another, value\n7, spawned, no name\n0 7\nNo such file or directory\n");
    ASSERT_THAT(report()["log"]["first"], SizeIs(1));
    EXPECT_THAT(report()["log"]["first"][0].get<std::string>(),
                StartsWith("/none cannot be run: it is not in the folder of --linux-root, at"));
}
TEST_F(Processes, ShareMemoryAndLocks) {
    prints_without_a_message("shares", "60, 6, 3 abc\n0 -1\n");
}
TEST_F(Processes, WaitForSemaphoresOfSystemV) {
    prints_without_a_message("semaphores", "0, 0 left, -1: Resource temporarily unavailable\n");
}
TEST_F(Processes, WaitForEvents) { prints_without_a_message("events", "8, 40\n"); }
TEST_F(Processes, HaveGroupsAndSessions) {
    prints_without_a_message("groups",
                             "1 1 -1\nS, 1 1, -1 Operation not permitted, -1, signal 15\n");
}
TEST_F(Processes, AreBoundedInNumber) {
    prints("bombs", "Resource temporarily unavailable after 255\n");
    EXPECT_THAT(report()["log"]["first"][0].get<std::string>(),
                HasSubstr("and with it 255 processes that it had begun"));
}
TEST_F(Processes, ThatWaitForEachOtherAreADeadlock) {
    EXPECT_EQ(run("hangs").exit_code, 1);
    ASSERT_THAT(report()["faults"], SizeIs(1));
    EXPECT_THAT(report()["faults"][0].get<std::string>(),
                EndsWith("thread 101: the end of a process; thread 102: input from a pipe"));
}
TEST_F(Processes, ExchangeDatagrams) {
    prints_without_a_message("udp",
                             "server: ping from 127.0.0.1:32768\nclient: pong\n"
                             "client: -1, Resource temporarily unavailable\n");
}
TEST_F(Processes, ConnectToAServer) {
    prints_without_a_message("tcp", "1 3 IBM, end 0\n1 3 IBM, end 0\n-1: Connection refused\n");
}
TEST_F(Processes, TalkBySocketsWithAName) {
    prints_without_a_message("unix", "7 one two, 0 -1, 5 th ree, 0\n");
}
TEST_F(Processes, ReachNothingOutside) {
    prints("outside", "-1: Network is unreachable\n-1: Network is unreachable\n");
    ASSERT_THAT(report()["log"]["first"], SizeIs(1));
    EXPECT_THAT(report()["log"]["first"][0].get<std::string>(),
                StartsWith("192.168.1.1:80 is not reachable: the simulated Linux has no network"));
}
TEST_F(Processes, SeeTheirOpenFilesAndThreadsByName) {
    prints_without_a_message("names",
                             "/dev/ttyS0, /dev/tty, 2 threads, 5 files: pipe: 11 from a pipe\n"
                             "processes\n"
                             "/dev/stdout 1 4,64\n"
                             "/dev/tty 1 5,0\n"
                             "/dev/console 1 5,1\n"
                             "/dev/ttyS0 1 4,64\n"
                             "-1\n");
}
TEST_F(Processes, CannotWriteToAFileOutsideOfTheirRoot) {
    folder.put("input.txt", "as it was");
    const std::filesystem::path file = folder / "input.txt";
    const auto rights = std::filesystem::status(file).permissions();
    const tb::Outcome outcome =
        play(scenario("duration: 10ms\n"), {"--elf", LINUX_PROGRAMS "processes", "--frames", "none",
                                            "--quiet", "--stdin", file, "--", "input"});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_EQ(console(), "-1, Read-only file system, -1, -1, 9 as it was\n");
    EXPECT_EQ(folder.get("input.txt"), "as it was");
    EXPECT_EQ(std::filesystem::status(file).permissions(), rights);
}
TEST_F(Processes, SeeFilesOfTheBoardsSystem) {
    prints_without_a_message("files", "processor\t: 0\nName:\tprocesses\n0-1\n2 processors\n");
}

}  // namespace
