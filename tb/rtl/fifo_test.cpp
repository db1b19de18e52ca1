// fifo.v against std::deque, and its rules one by one.
#include <deque>
#include <random>

#include <gtest/gtest.h>

#include "Vfifo.h"
#include "tb/support/random_registers.h"

namespace {

constexpr std::size_t DEPTH = 128;

class Fifo : public ::testing::Test {
protected:
    static void SetUpTestSuite() { tb::start_with_random_registers(); }
    void SetUp() override {
        dut.rst_i = 1;
        step(false, 0, false);
        dut.rst_i = 0;
    }

    // One clock; the model moves by the rules in the module's header.
    void step(bool push, std::uint32_t word, bool pop, bool clear = false) {
        dut.push_i = push;
        dut.wdata_i = word;
        dut.pop_i = pop;
        dut.clear_i = clear;
        dut.clk_i = 0;
        dut.eval();
        dut.clk_i = 1;
        dut.eval();
        const bool room = model.size() < DEPTH;
        if (pop && !model.empty()) model.pop_front();
        if (push && room) model.push_back(word);
        if (clear) model.clear();
    }
    void check() {
        ASSERT_EQ(dut.count_o, model.size());
        ASSERT_EQ(dut.empty_o, model.empty());
        ASSERT_EQ(dut.full_o, model.size() == DEPTH);
        if (!model.empty()) {
            ASSERT_EQ(dut.rdata_o, model.front());
        }
    }

    Vfifo dut;
    std::deque<std::uint32_t> model;
};

TEST_F(Fifo, BehavesLikeADequeUnderRandomTraffic) {
    std::mt19937 random{1};
    for (int phase = 0; phase < 400; ++phase) {
        const unsigned push = random() % 101, pop = random() % 101;  // percent
        for (int i = 0; i < 300; ++i) {
            const bool clear = random() % 2000 == 0;
            step(random() % 100 < push, static_cast<std::uint32_t>(random()), random() % 100 < pop,
                 clear);
            check();
            if (HasFatalFailure()) FAIL() << "phase " << phase << ", clock " << i;
        }
    }
}

TEST_F(Fifo, BehavesLikeADequeWhileItHoldsNextToNothing) {
    std::mt19937 random{2};
    for (int i = 0; i < 100'000; ++i) {
        step(random() % 2 && model.size() < 3, static_cast<std::uint32_t>(random()), random() % 2);
        check();
        if (HasFatalFailure()) FAIL() << "clock " << i;
    }
}

TEST_F(Fifo, ShowsAWordInTheClockAfterItsPush) {
    step(true, 0xc0ffee, false);
    EXPECT_EQ(dut.empty_o, 0);
    EXPECT_EQ(dut.rdata_o, 0xc0ffeeu);
}

TEST_F(Fifo, HandsAWordOnEveryClock) {
    step(true, 1, false);
    for (std::uint32_t word = 2; word < 1000; ++word) {
        step(true, word, true);
        EXPECT_EQ(dut.rdata_o, word);
        EXPECT_EQ(dut.count_o, 1);
    }
}

TEST_F(Fifo, DropsAPushWhenFullEvenBesideAPop) {
    for (std::uint32_t word = 0; word < DEPTH; ++word) step(true, word, false);
    EXPECT_EQ(dut.full_o, 1);
    step(true, 1000, false);
    step(true, 1001, true);
    EXPECT_EQ(dut.count_o, DEPTH - 1);
    for (std::uint32_t word = 1; word < DEPTH; ++word) {
        EXPECT_EQ(dut.rdata_o, word);
        step(false, 0, true);
    }
    EXPECT_EQ(dut.empty_o, 1);
}

TEST_F(Fifo, KeepsAWordPushedDuringAPopWhenEmpty) {
    step(true, 5, true);
    EXPECT_EQ(dut.count_o, 1);
    EXPECT_EQ(dut.rdata_o, 5u);
}

TEST_F(Fifo, ClearBeatsAPush) {
    step(true, 1, false);
    step(true, 2, false, true);
    EXPECT_EQ(dut.empty_o, 1);
    step(true, 3, false);
    EXPECT_EQ(dut.rdata_o, 3u);
    EXPECT_EQ(dut.count_o, 1);
}

}  // namespace
