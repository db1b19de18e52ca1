// linux_programs_test.cpp - Linux programs on the modelled Cortex-A9, by the command line.
#include <gmock/gmock.h>

#include <sys/stat.h>

#include <fstream>

#include "tb/system/cli.h"

namespace {

using ::testing::ElementsAre;
using ::testing::EndsWith;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

class LinuxProgram : public tb::CommandLine {
protected:
    // Runs the program NAME with `arguments` after --, and `options` before.
    tb::Outcome linux_run(const std::string& name, const std::vector<std::string>& arguments = {},
                          std::vector<std::string> options = {},
                          const std::string& steps = "duration: 100ms\n") const {
        options.insert(options.begin(), {"--cpu", "arm", "--elf", LINUX_PROGRAMS + name, "--frames",
                                         "none", "--quiet"});
        options.push_back("--");
        options.insert(options.end(), arguments.begin(), arguments.end());
        return play(scenario(steps), options);
    }
    std::string console() const { return file("console.txt"); }
    // faults CASE ends the run as a fault of the firmware, in one line that says `why`.
    void expect_end(const std::string& which, const std::vector<std::string>& why) const {
        const tb::Outcome outcome = linux_run("faults", {which});
        EXPECT_EQ(outcome.exit_code, 1);
        EXPECT_EQ(report()["end"], "firmware fault");
        ASSERT_THAT(report()["faults"], SizeIs(1));
        for (const std::string& part : why)
            EXPECT_THAT(report()["faults"][0].get<std::string>(), HasSubstr(part));
    }
    void refused(const tb::Outcome& outcome, const std::string& message) const {
        EXPECT_EQ(outcome.exit_code, 2);
        EXPECT_THAT(tb::lines_of(outcome.err), SizeIs(1));
        EXPECT_THAT(outcome.err, HasSubstr(message));
    }
};

TEST_F(LinuxProgram, PrintsAllocatesThrowsAndGetsItsArguments) {
    const tb::Outcome outcome = linux_run("hello", {"a", "b c"});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_EQ(console(),
              "/hello with 2 arguments: [a] [b c]\n"
              "sum 3264000, kept 255\n"
              "999 squared is 998001, half of 3 is 1.5\n"
              "caught\n");
    EXPECT_EQ(report()["program"]["exit_code"], 0);
    EXPECT_THAT(report()["log"]["first"], IsEmpty());
}

TEST_F(LinuxProgram, IsLinkedDynamicallyAsOnTheBoard) {
    for (const std::string name : {"hello_pie", "hello_no_pie"}) {
        const tb::Outcome outcome = linux_run(name, {"a", "b c"});
        EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
        EXPECT_EQ(console(), "/" + name +
                                 " with 2 arguments: [a] [b c]\n"
                                 "sum 3264000, kept 255\n"
                                 "999 squared is 998001, half of 3 is 1.5\n"
                                 "caught\n");
        EXPECT_THAT(report()["log"]["first"], IsEmpty());
    }
}

// The library's name leads to it by a symbolic link, as on the board.
TEST_F(LinuxProgram, LoadsALibraryOfItsOwnFromItsRoot) {
    std::filesystem::create_directories(folder / "root/usr/lib");
    std::filesystem::copy(LINUX_PROGRAMS "libgreet.so.1.0", folder / "root/usr/lib");
    std::filesystem::create_symlink("/usr/lib/libgreet.so.1.0",
                                    folder / "root/usr/lib/libgreet.so.1");
    const std::vector<std::string> root{"--linux-root", folder / "root"};
    EXPECT_EQ(linux_run("greets", {}, root).exit_code, 0);
    EXPECT_EQ(console(), "greetings from the library\n");
    EXPECT_EQ(linux_run("greets", {"crash"}, root).exit_code, 1);
    EXPECT_THAT(report()["faults"][0].get<std::string>(),
                AllOf(HasSubstr("SIGSEGV: write to 0x00000000"), HasSubstr(" in greet+"),
                      EndsWith(" of libgreet.so.1")));
}

TEST_F(LinuxProgram, LogsALibraryThatItLookedForInVain) {
    std::filesystem::create_directories(folder / "root/usr/lib");
    std::filesystem::copy(LINUX_PROGRAMS "libgreet.so.1.0", folder / "root/usr/lib/libgreet.so.1");
    EXPECT_EQ(linux_run("greets", {"a", "b"}, {"--linux-root", folder / "root"}).exit_code, 0);
    EXPECT_THAT(
        report()["log"]["first"],
        ElementsAre("the program looked for the library libsongs.so.2, which is not there"));
}

TEST_F(LinuxProgram, SaysWhyALibraryDoesNotFit) {
    std::filesystem::create_directories(folder / "root/usr/lib");
    const std::filesystem::path library = folder / "root/usr/lib/libgreet.so.1";
    const auto why = [&] {
        EXPECT_EQ(linux_run("greets", {}, {"--linux-root", folder / "root"}).exit_code, 1);
        return report()["faults"][0].get<std::string>();
    };
    std::filesystem::copy("/bin/true", library);
    EXPECT_THAT(why(), HasSubstr("libgreet.so.1; but /usr/lib/libgreet.so.1 is a 64-bit ELF file"));
    std::filesystem::remove(library);
    std::filesystem::copy(LINUX_PROGRAMS "libgreet.so.1.0", library);
    std::fstream file{library, std::ios::in | std::ios::out | std::ios::binary};
    file.seekp(36);  // e_flags
    file.write("\x00\x02\x00\x05", 4);
    file.close();
    EXPECT_THAT(why(), HasSubstr("/usr/lib/libgreet.so.1 is for the soft-float ABI: copy it from"));
}

TEST_F(LinuxProgram, NamesALibraryThatIsNotThere) {
    EXPECT_EQ(linux_run("greets").exit_code, 1);
    EXPECT_THAT(report()["faults"][0].get<std::string>(),
                HasSubstr("the program needs the library libgreet.so.1, which is not there: copy "
                          "it from the board into /usr/lib of the folder of --linux-root"));
}

TEST_F(LinuxProgram, NamesAnInterpreterThatIsNotThere) {
    std::filesystem::copy(LINUX_PROGRAMS "hello_pie", folder / "other");
    std::string elf = folder.get("other");
    elf.replace(elf.find("/lib/ld-linux-armhf.so.3"), 24, "/lib/ld-linux-armxx.so.3");
    folder.put("other", elf);
    const tb::Outcome outcome =
        play(scenario("duration: 1ms\n"), {"--elf", folder / "other", "--quiet"});
    EXPECT_EQ(outcome.exit_code, 1);
    EXPECT_THAT(outcome.err, HasSubstr("its interpreter /lib/ld-linux-armxx.so.3 is not there"));
}

TEST_F(LinuxProgram, IsNoSharedLibrary) {
    refused(linux_run("libgreet.so.1.0", {}, {"--system", "linux"}),
            "a shared library, expected a program");
}

// As Linux 6.1 answers it under QEMU.
TEST_F(LinuxProgram, GetsByEpollWhatLinuxGives) {
    EXPECT_EQ(linux_run("epoll").exit_code, 0);
    EXPECT_EQ(console(),
              "empty: 0\n"
              "add a: done\n"
              "add a again: File exists\n"
              "change b: No such file or directory\n"
              "delete b: No such file or directory\n"
              "add itself: Invalid argument\n"
              "add none: Bad file descriptor\n"
              "nothing to read: 0\n"
              "by level: 1, a 1\n"
              "by level: 1, a 1\n"
              "read: 0\n"
              "add b by edge: done\n"
              "add b to write: done\n"
              "both: 2, b 1, e 4\n"
              "an edge, and once: 0\n"
              "once more: done\n"
              "once more: 1, e 4\n"
              "the next edge: 1, b 1\n"
              "add counter: done\n"
              "add timer: done\n"
              "timer: 1, d 1\n"
              "counter: 1, c 1\n"
              "add inner: done\n"
              "inner rests: 0\n"
              "add outer to inner: Too many levels of symbolic links\n"
              "inner has one: 1, a 1\n"
              "hung up: 1, a 10\n"
              "closed: 0\n"
              "add pipe: done\n"
              "a watched number is its own: 0\n");
}

TEST_F(LinuxProgram, ReadsAndWritesFilesUnderItsRootOnly) {
    folder.put("outside.txt", "secret");
    std::filesystem::create_directories(folder / "root/inside");
    std::filesystem::create_directories(folder / "root/data");
    folder.put("root/data/in.txt", "hello\nlast\n");
    std::filesystem::create_symlink("../outside.txt", folder / "root/link");
    std::filesystem::create_symlink("..", folder / "root/folder_link");
    std::filesystem::create_symlink("/inside/../data", folder / "root/inside/to_data");
    std::filesystem::create_symlink("round", folder / "root/round");
    ASSERT_EQ(mkfifo((folder / "root/fifo").c_str(), 0600), 0);
    EXPECT_EQ(linux_run("files", {}, {"--linux-root", folder / "root"}).exit_code, 0);
    EXPECT_EQ(console(),
              "read hello\n"
              "last last\n"
              "wrote 8890 bytes, file\n"
              "mapped hello\n"
              "ioctl: Inappropriate ioctl for device\n"
              "./ ../ in.txt out.txt in /data\n"
              "in /\n"
              "in /data by a link\n"
              "not followed: Too many levels of symbolic links\n"
              "not made by a link: File exists, File exists\n"
              "rights 0, 640, none, Operation not permitted\n"
              "../outside.txt: No such file or directory\n"
              "/data/../../outside.txt: No such file or directory\n"
              "/link: No such file or directory\n"
              "/folder_link/outside.txt: No such file or directory\n"
              "/folder_link/inside/to_data/in.txt: open\n"
              "/round: Too many levels of symbolic links\n"
              "/none: No such file or directory\n"
              "/fifo: Permission denied\n");
    const std::string written = folder.get("root/data/out.txt");
    EXPECT_EQ(written.size(), 8890u);
    EXPECT_THAT(written, EndsWith("line 998\nline 999\n"));
}

// As the program prints on a PC.
TEST_F(LinuxProgram, MapsFilesThatOthersChange) {
    std::filesystem::create_directories(folder / "root/data");
    EXPECT_EQ(linux_run("mapped_files", {}, {"--linux-root", folder / "root"}).exit_code, 0);
    EXPECT_EQ(console(),
              "of the child, 16\n"
              "of the child\n"
              "by write, done\n"
              "signal 7, code 2, 8192\n"
              "Bad address\n"
              "b\n"
              "c\n"
              "signal 7, code 2, 4096\n"
              "e\n"
              "signal 7, code 2, 0\n"
              "g\n"
              "h\n"
              "done\n"
              "done\n"
              "h, Permission denied\n"
              "Permission denied\n"
              "h i\n"
              "signal 11, code 2, 0\n"
              "signal 11, code 1, 0\n");
    EXPECT_EQ(folder.get("root/data/mapped.bin").substr(7 * 4096, 1), "h");
}

TEST_F(LinuxProgram, SeesNoFilesWithoutARoot) {
    const tb::Outcome outcome = linux_run("files");
    EXPECT_EQ(outcome.exit_code, 1);
    EXPECT_THAT(outcome.err, HasSubstr("the program ended with exit code 1 "));
}

TEST_F(LinuxProgram, WaitsInSimulatedTimeForALineThatIsTyped) {
    const tb::Outcome outcome = linux_run("asks", {}, {},
                                          "steps:\n  - wait-serial: \"Number? \"\n"
                                          "  - delay: 50ms\n"
                                          "  - type-serial: \"1\"\n  - delay: 20ms\n"
                                          "  - type-serial: \"6\\x082\\n\"\n"
                                          "  - wait-serial: squared 144\n"
                                          "  - expect-leds: 144\n"
                                          "  - type-serial: \"3\\n4\\n\\x04\"\n"
                                          "  - wait-serial: no more\n");
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_EQ(console(),
              "Number? 12\nsquared 144\nNumber? 3\nsquared 9\nNumber? 4\nsquared 16\n"
              "Number? no more\n");
    const double asked_s = report()["expectations"][0]["time_s"],
                 answered_s = report()["expectations"][1]["time_s"];
    EXPECT_NEAR(answered_s - asked_s, 0.074, 0.0005) << "a character takes 1 ms";
}

TEST_F(LinuxProgram, ReportsThatItWaitsForInputWhichDoesNotCome) {
    linux_run("asks");
    EXPECT_EQ(report()["program"]["at"]["waiting_for"], "standard input");
    EXPECT_EQ(console(), "Number? ");
}

TEST_F(LinuxProgram, ReadsItsInputFromAFile) {
    folder.put("in.txt", "5\n7");
    EXPECT_EQ(linux_run("asks", {}, {"--stdin", folder / "in.txt"}).exit_code, 0);
    EXPECT_EQ(console(),
              "Number? squared 25 (no terminal)\nNumber? squared 49 (no terminal)\n"
              "Number? no more\n");
    EXPECT_EQ(linux_run("asks", {}, {"--stdin", "/dev/null"}).exit_code, 0);
    EXPECT_EQ(console(), "Number? no more\n");
}

TEST_F(LinuxProgram, ReadsSingleCharactersInRawMode) {
    const tb::Outcome outcome = linux_run("asks", {"keys"}, {},
                                          "steps:\n  - delay: 5ms\n  - type-serial: \"wa\"\n"
                                          "  - wait-serial: \"[a]\"\n"
                                          "  - type-serial: \"q\"\n"
                                          "  - wait-serial: \"[q]\"\n");
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_EQ(console(), "[w]\n[a]\n[q]\n");
}

TEST_F(LinuxProgram, LooksForAKeyInItsLoopWithoutWaiting) {
    for (const std::string how : {"select", "poll", "read"}) {
        const tb::Outcome outcome = linux_run("game", {how}, {},
                                              "steps:\n  - delay: 50ms\n"
                                              "  - expect-leds: \"0000100000\"\n"
                                              "  - type-serial: \"aad\"\n  - delay: 90ms\n"
                                              "  - expect-leds: \"0001000000\"\n"
                                              "  - delay: 55ms\n  - type-serial: \"q\"\n"
                                              "  - wait-serial: over\n  - delay: 1ms\n");
        EXPECT_EQ(outcome.exit_code, 0) << how << outcome.err;
        EXPECT_EQ(console(), "over after 11 pictures\n") << how;
        EXPECT_THAT(report()["log"]["first"], IsEmpty()) << how;
    }
}

TEST_F(LinuxProgram, WaitsForAKeyUntilItsTimeout) {
    const tb::Outcome outcome = linux_run("game", {"waits"}, {},
                                          "steps:\n  - wait-serial: type\n  - delay: 40ms\n"
                                          "  - type-serial: \"ab\"\n  - delay: 40ms\n"
                                          "  - type-serial: \"\\n\"\n"
                                          "  - wait-serial: \"poll: 2, \"\n  - delay: 1ms\n");
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_EQ(console(),
              "select: 0 after 50 ms, 0 us left\npoll: 0 after 30 ms\ntype\n"
              "select: 1, in time\npoll: 1\nab\nread: 3\nselect: 0\npoll: 2, 1, 1\n");
    EXPECT_NEAR(report()["expectations"][1]["time_s"].get<double>() -
                    report()["expectations"][0]["time_s"].get<double>(),
                0.081, 0.0005)
        << "when the line is there";
}

TEST_F(LinuxProgram, WithoutAScenarioReadsEndOfFile) {
    EXPECT_EQ(de1sim({LINUX_PROGRAMS "asks", "--quiet", "--out", out.string()}).exit_code, 0);
    EXPECT_EQ(console(), "Number? no more\n");
}

TEST_F(LinuxProgram, SleepsInSimulatedTimeByEveryClock) {
    EXPECT_EQ(linux_run("clocks").exit_code, 0);
    EXPECT_EQ(console(),
              "nanosleep took 20 ms\nusleep took 20 ms\nclock_nanosleep took 20 ms\n"
              "until took 20 ms\n"
              "calls took 1 us each\n");
    EXPECT_NEAR(report()["program"]["asleep_s"].get<double>(), 0.08, 0.0002);
}

TEST_F(LinuxProgram, ReachesRegistersThroughDevMem) {
    const tb::Outcome outcome = linux_run("dev_mem", {}, {},
                                          "steps:\n  - wait-serial: leds read back 155\n"
                                          "  - expect-leds: \"0101010101\"\n"
                                          "  - wait-serial: an odd offset\n"
                                          "  - hold: {switch: [2, 7]}\n  - delay: 5ms\n"
                                          "  - expect-leds: \"0010000100\"\n");
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_EQ(console(),
              "leds read back 155\ntimer expired, status 0\nan odd offset: Invalid argument\n");
    EXPECT_NEAR(report()["expectations"][2]["time_s"].get<double>(), 0.005, 0.0002)
        << "when the A9's timer has expired";
}

TEST_F(LinuxProgram, NeedsNeitherACLibraryNorFloatingPointRegisters) {
    EXPECT_EQ(linux_run("soft_float", {}, {"--system", "linux"}).exit_code, 0);
    EXPECT_EQ(console(), "soft\n");
}

TEST_F(LinuxProgram, IsEndedByAWrongAccess) {
    expect_end("segv", {"SIGSEGV: write to 0x00000010", "in write_to_nowhere"});
    expect_end("constant", {"SIGSEGV: write to 0x000", " in main"});
    expect_end("nowhere", {"SIGSEGV: no instruction to be read", "PC 0x40000000"});
    expect_end("undefined", {"SIGILL: undefined instruction", " in main"});
}

TEST_F(LinuxProgram, IsEndedByAnAccessThatNobodyAnswers) {
    expect_end("bus", {"SIGBUS", "read of 4 bytes at 0xFFC00000", "in read_unanswered"});
}

// As the kernel's alignment trap does by default.
TEST_F(LinuxProgram, MayAccessUnalignedWordsWhereLinuxMendsIt) {
    EXPECT_EQ(linux_run("unaligned").exit_code, 0);
    EXPECT_EQ(console(),
              "ldr 04030201\n"
              "ldm 06050403 0a090807\n"
              "strd 0\n"
              "vldr SIGBUS at +2\n"
              "ldrex SIGBUS at +1\n"
              "leds 00000001\n"
              "ldr.w SIGBUS at +1\n");
    const nlohmann::json log = report()["log"]["first"];
    ASSERT_THAT(log, SizeIs(4)) << "LDM, STRD, and the LDR of a device, beside LEDR";
    EXPECT_THAT(log[0].get<std::string>(),
                AllOf(HasSubstr("ldm.w r"), HasSubstr("Linux does it byte by byte")));
}

TEST_F(LinuxProgram, IsEndedByAbort) { expect_end("abort", {"SIGABRT"}); }

TEST_F(LinuxProgram, FailsTheRunByAnExitCode) {
    expect_end("exit", {"the program ended with exit code 3"});
    EXPECT_EQ(report()["program"]["exit_code"], 3);
}

TEST_F(LinuxProgram, HandlesItsSignals) {
    EXPECT_EQ(linux_run("faults", {"handled"}).exit_code, 0);
    EXPECT_EQ(console(), "handler: signal 11 at 0x10\nraised 1, goes on\n");
}

TEST_F(LinuxProgram, GetsOneMessageForAnUnknownCallAndGoesOn) {
    EXPECT_EQ(linux_run("faults", {"unknown"}).exit_code, 0);
    EXPECT_EQ(console(), "-1 -1\n-1\n");
    const nlohmann::json log = report()["log"]["first"];
    ASSERT_THAT(log, SizeIs(2));
    EXPECT_THAT(log[0].get<std::string>(),
                HasSubstr("system call 360 (inotify_init1) is not emulated"));
    EXPECT_THAT(log[1].get<std::string>(), HasSubstr("system call 9999 is not emulated"));
    EXPECT_EQ(report()["faults"].size(), 0u) << "it succeeds all the same";
}

TEST_F(LinuxProgram, FailsByCallsThatAreNotEmulatedUnlessItSucceeds) {
    const tb::Outcome outcome =
        play(scenario("steps:\n  - expect-leds: {equals: 1, timeout: 1ms}\n"),
             {"--elf", LINUX_PROGRAMS "faults", "--frames", "none", "--", "unknown"});
    EXPECT_EQ(outcome.exit_code, 1);
    ASSERT_EQ(report()["faults"].size(), 2u);
    EXPECT_THAT(report()["faults"][0].get<std::string>(),
                StartsWith("the simulated Linux does not have a call of the program: 9999, at "));
    EXPECT_THAT(report()["faults"][1].get<std::string>(),
                AllOf(HasSubstr("inotify_init1, 2 times, first at "), HasSubstr(" in syscall+")));
    EXPECT_THAT(outcome.err, HasSubstr("the program has ended itself with exit code 0"));
}

TEST_F(LinuxProgram, IsTheSameToTheByteEveryTime) {
    const auto once = [this] {
        EXPECT_EQ(linux_run("hello", {"x"}).exit_code, 0);
        nlohmann::json all = report();
        all.erase("wall");
        return all.dump() + console();
    };
    const std::string first = once();
    EXPECT_EQ(once(), first);
}

TEST_F(LinuxProgram, RefusesOptionsThatAreNotForItsSystem) {
    scenario("duration: 1ms\n");
    refused(play("s.yaml", {"--cpu", "arm", "--elf", LEDS_ELF, "--", "x"}),
            "arguments after -- are for Linux programs");
    refused(play("s.yaml", {"--cpu", "arm", "--elf", LEDS_ELF, "--linux-root", "."}),
            "--linux-root is for Linux programs");
    refused(play("s.yaml", {"--elf", LEDS_ELF, "--stdin", "s.yaml"}),
            "--stdin is for Linux programs");
    refused(linux_run("hello", {}, {"--stdin", folder / "none"}),
            "none: cannot be standard input: No such file or directory");
    refused(linux_run("hello", {}, {"--stdin", folder.path()}),
            ": cannot be standard input: is a folder");
    refused(linux_run("hello", {}, {"--stdin", "/dev/zero"}),
            "/dev/zero: cannot be standard input: is a pipe or a device, expected a file");
    refused(play("s.yaml", {"--", "x"}), "--: is for --cpu arm");
    refused(play("s.yaml", {"--system", "linux"}), "--system: is for --cpu arm");
    refused(linux_run("hello", {}, {"--linux-root", folder / "none"}),
            "none: cannot open as the program's root: No such file or directory");
}

}  // namespace
