// Answers: which of a program's accesses to the bus would give the same again.
#include <gtest/gtest.h>

#include "sim/cpu/answers.h"

namespace {

constexpr std::uint32_t STATUS = 0x40, FIFO = 0x48, LAMPS = 0x50, EPOCH = 7;
constexpr bool READ = false, WRITE = true, PLAIN = true;

class Answers : public testing::Test {
protected:
    void SetUp() override { answers.made(STATUS, 4, READ, 1, PLAIN, EPOCH); }
    bool is_sure(std::uint64_t epoch = EPOCH) {
        const auto known = answers.last(STATUS, 4, READ, epoch);
        return known && known->value == 1 && known->sure;
    }

    sim::Answers answers;
};

TEST_F(Answers, AreSureAsLongAsNothingHasChanged) {
    EXPECT_TRUE(is_sure());
    EXPECT_FALSE(is_sure(EPOCH + 1));
}

TEST_F(Answers, StaySureAfterAReadWithoutAnEffect) {
    answers.made(FIFO, 4, READ, 5, PLAIN, EPOCH);
    EXPECT_TRUE(is_sure());
}

// It may have taken the last sample out of a FIFO, of which the status tells.
TEST_F(Answers, AreNotSureAfterAReadThatHasAnEffect) {
    answers.made(FIFO, 4, READ, 5, !PLAIN, EPOCH);
    EXPECT_FALSE(is_sure());
}

TEST_F(Answers, AreNotSureAfterAWrite) {
    answers.made(LAMPS, 4, WRITE, 5, PLAIN, EPOCH);
    EXPECT_FALSE(is_sure());
}

TEST_F(Answers, StaySureAfterTheSameWriteAgain) {
    answers.made(LAMPS, 4, WRITE, 5, PLAIN, EPOCH);
    SetUp();
    answers.made(LAMPS, 4, WRITE, 5, PLAIN, EPOCH);
    EXPECT_TRUE(is_sure());
}

}  // namespace
