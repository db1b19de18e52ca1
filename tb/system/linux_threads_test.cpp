// linux_threads_test.cpp - threads of Linux programs, by the C library and by C++.
#include <gmock/gmock.h>

#include "tb/system/cli.h"

namespace {

using ::testing::EndsWith;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

class Threads : public tb::CommandLine {
protected:
    tb::Outcome run(const std::string& what, const std::string& program = "threads") const {
        return play(scenario("duration: 400ms\n"),
                    {"--elf", LINUX_PROGRAMS + program, "--frames", "none", "--quiet", "--", what});
    }
    std::string console() const { return file("console.txt"); }
    // The program prints this, and ends well.
    void prints(const std::string& what, const std::string& text) const {
        const tb::Outcome outcome = run(what);
        EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
        EXPECT_EQ(console(), text);
        EXPECT_THAT(report()["log"]["first"], IsEmpty());
    }
};

TEST_F(Threads, CountOnTheLampsUnderAMutex) { prints("counts", "counted to 100, LEDs 100\n"); }
TEST_F(Threads, ProduceAndConsume) { prints("produces", "took 300, sum 314850\n"); }
TEST_F(Threads, PostSemaphores) { prints("posts", "-1: Connection timed out after 5 ms\n"); }
TEST_F(Threads, MeetAtABarrier) { prints("meets", "20 rounds, 0 late\n"); }
TEST_F(Threads, ReadTogetherAndWriteAlone) {
    prints("shares", "20 writes, 0 amid readers, readers together\n");
}
TEST_F(Threads, HaveTheirOwnRegistersErrnoAndVariables) {
    prints("keeps", "3 right, own 1, destroyed 6\n");
}
TEST_F(Threads, RunBesideOneThatSpins) { prints("spins", "at once, spun\n"); }
TEST_F(Threads, HaveEqualParts) { prints("turns", "halves\n"); }
TEST_F(Threads, CanBeCancelled) { prints("cancels", "cleaned up\ncancelled, cancelled\n"); }
TEST_F(Threads, MayOutliveTheFirst) { prints("outlives", "the first\nthe last\n"); }
TEST_F(Threads, WaitForAConditionUntilTheirTimeout) {
    prints("waits", "Connection timed out after 7 ms\n");
}
TEST_F(Threads, LeaveRobustMutexesToOthers) { prints("inherits", "Owner died\n"); }
TEST_F(Threads, HaveTheirOwnSignals) {
    prints("signals", "by the thread, took 12, by the first\n");
}
TEST_F(Threads, HaveAPolicyAndAProcessor) {
    prints("schedules", "0 1, 0 1, 1 to 99, processor 1\n");
}
TEST_F(Threads, ComeInThousandsButNotAtOnce) { prints("storms", "no more threads\n"); }

TEST_F(Threads, ThatWaitForEachOtherAreADeadlock) {
    EXPECT_EQ(run("deadlocks").exit_code, 1);
    ASSERT_THAT(report()["faults"], SizeIs(1));
    const std::string text = report()["faults"][0];
    EXPECT_THAT(text, HasSubstr("deadlock: no thread can ever go on at 1."));
    EXPECT_THAT(text, HasSubstr("thread 101: the mutex at 0x"));
    EXPECT_THAT(text, EndsWith("that thread 101 has"));
}

TEST_F(Threads, ThatWaitAlikeAreOneReason) {
    EXPECT_EQ(run("crowd").exit_code, 0);
    EXPECT_EQ(report()["program"]["at"]["waiting_for"],
              "thread 101: the time to wake up; threads 102 to 151: a signal");
}

TEST_F(Threads, AreThoseOfCppToo) {
    const tb::Outcome outcome = run("", "threads_of_cpp");
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_EQ(console(), "sum 15\nall 4999950000\ncaught as it should\nonce, 0 1, 2 processors\n");
}

TEST_F(Threads, AreTheSameToTheByteEveryTime) {
    run("shares");
    const nlohmann::json first = report()["program"];
    run("shares");
    EXPECT_EQ(report()["program"], first);
}

}  // namespace
