// linux_storms_test.cpp - Linux programs that take what they can get, and what is left for the run.
#include <gmock/gmock.h>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <thread>

#include "tb/system/cli.h"

namespace {

using ::testing::EndsWith;
using ::testing::HasSubstr;

class LinuxStorm : public tb::CommandLine {
protected:
    tb::Outcome storm(const std::string& which, const std::string& duration,
                      const std::string& shell = "") const {
        std::filesystem::create_directories(folder / "root");
        tb::Command command;
        command.shell = shell;
        return play(scenario("duration: " + duration + "\n"),
                    {"--cpu", "arm", "--elf", LINUX_PROGRAMS "storms", "--frames", "none",
                     "--quiet", "--linux-root", folder / "root", "--", which},
                    command);
    }
    std::string console() const { return file("console.txt"); }
};

// 115,200 baud with a start and a stop bit, after the 4,096 characters of the kernel's buffer.
TEST_F(LinuxStorm, PrintsNoFasterThanTheSerialLineOfTheBoard) {
    EXPECT_EQ(storm("prints", "1s").exit_code, 0);
    EXPECT_GT(console().size(), 11'520u);
    EXPECT_LE(console().size(), 11'520u + 4'096);
}

TEST_F(LinuxStorm, WaitsInOneWriteUntilTheLineHasTakenIt) {
    EXPECT_EQ(storm("prints-at-once", "10s").exit_code, 0);
    EXPECT_EQ(console().substr(104'096), "\n4096 in 0 ms, 100000 in 8681 ms\n");
}

TEST_F(LinuxStorm, GetsEagainFromAFullLineWithoutBlocking) {
    EXPECT_EQ(storm("prints-unless-full", "1s").exit_code, 0);
    EXPECT_THAT(console(), EndsWith("\n4096, then -1\n"));
}

TEST_F(LinuxStorm, LeavesFilesForTheRunWhenItOpensAll) {
    std::filesystem::create_directories(folder / "root");
    folder.put("root/file", "x");
    const tb::Outcome outcome = storm("opens", "50ms", "ulimit -n 128");
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_EQ(console(), "many files: Too many open files\n");
}

TEST_F(LinuxStorm, HasFourTimesTheBoardsMemoryInAllProcesses) {
    EXPECT_EQ(storm("forks-with-memory", "400ms").exit_code, 0);
    EXPECT_EQ(console(), "7 children: Cannot allocate memory\n");
}

TEST_F(LinuxStorm, SharesNoMoreMemoryThanTheBoardHas) {
    EXPECT_EQ(storm("shares-memory", "400ms").exit_code, 0);
    EXPECT_EQ(console(), "4 files: No space left on device\n");
}

TEST_F(LinuxStorm, LeavesTheHostsAreasForTheRun) {
    EXPECT_EQ(storm("maps-pages", "400ms").exit_code, 0);
    EXPECT_EQ(console(), "Cannot allocate memory, the first, Cannot allocate memory\n");
}

TEST_F(LinuxStorm, LeavesFilesForTheRunWhenItSharesMany) {
    EXPECT_EQ(storm("shares-files", "50ms", "ulimit -n 128").exit_code, 0);
    EXPECT_EQ(console(), "many files: Cannot allocate memory\n");
}

TEST_F(LinuxStorm, NeverOpensWhatIsNeitherFileNorFolder) {
    std::filesystem::create_directories(folder / "root");
    const std::string fifo = folder / "root/fifo";
    ASSERT_EQ(mkfifo(fifo.c_str(), 0600), 0);
    std::atomic<bool> met{false};
    std::thread reader{[&] {
        const int fd = open(fifo.c_str(), O_RDONLY | O_CLOEXEC);  // waits for somebody who writes
        met = true;
        close(fd);
    }};
    EXPECT_EQ(storm("fifo", "50ms").exit_code, 0);
    EXPECT_EQ(console(), "/fifo: Permission denied\n");
    EXPECT_FALSE(met);
    const int fd = open(fifo.c_str(), O_RDWR | O_CLOEXEC);
    reader.join();
    close(fd);
}

}  // namespace
