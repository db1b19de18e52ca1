// The memories and FIFOs of the LPM library, by Quartus' help on each; the references are an array
// and std::deque.

#include "Vmemories_bench.h"

#include <gmock/gmock.h>

#include <array>
#include <cstdint>
#include <deque>
#include <random>

namespace {

class Memories : public testing::Test {
protected:
    Memories() {
        dut.enable_i = 1;
        dut.eval();
    }

    void write_clock() {
        dut.wrclock_i = 1;
        dut.eval();
        dut.wrclock_i = 0;
        dut.eval();
    }
    void read_clock() {
        dut.rdclock_i = 1;
        dut.eval();
        dut.rdclock_i = 0;
        dut.eval();
    }

    std::mt19937 random{5};
    Vmemories_bench dut;
};

TEST_F(Memories, ReadAtOneClockWhatAnotherWrote) {
    std::array<std::uint8_t, 16> words{}, late_words{};
    std::uint8_t shown = 0, taken = 0, late = 0;
    for (int i = 0; i < 3000; ++i) {
        dut.data_i = random() & 255;
        dut.wraddress_i = random() & 15;
        dut.rdaddress_i = random() & 15;
        dut.wrreq_i = random() & 1;
        dut.rdreq_i = random() & 1;
        dut.enable_i = random() & 1;
        if (random() & 1) {
            if (dut.wrreq_i && dut.enable_i) words[dut.wraddress_i] = dut.data_i;
            if (dut.wrreq_i) late_words[dut.wraddress_i] = dut.data_i;
            write_clock();
        } else {
            if (dut.rdreq_i) shown = words[dut.rdaddress_i];
            if (dut.enable_i) {
                late = taken;
                taken = late_words[dut.rdaddress_i];
            }
            read_clock();
        }
        ASSERT_EQ(dut.ram_o, shown) << i;
        ASSERT_EQ(dut.late_ram_o, late) << i;
    }
}

TEST_F(Memories, KeepTheOrderInAFifoOfOneClock) {
    std::deque<std::uint8_t> words;
    std::uint8_t shown = 0;
    unsigned fills = 0;
    for (int i = 0; i < 3000; ++i) {
        dut.data_i = random() & 255;
        dut.wrreq_i = random() % 8 < (i / 100 % 2 ? 6 : 2);
        dut.rdreq_i = random() & 1;
        dut.eval();
        const bool reads = dut.rdreq_i && !words.empty();
        const bool writes = dut.wrreq_i && words.size() < 8;
        if (reads) {
            shown = words.front();
            words.pop_front();
        }
        if (writes) words.push_back(dut.data_i);
        write_clock();
        ASSERT_EQ(dut.q_o, shown) << i;
        ASSERT_EQ(dut.used_o, words.size() % 8);
        ASSERT_EQ(dut.full_o, words.size() == 8);
        ASSERT_EQ(dut.empty_o, words.empty());
        fills += words.size() == 8;
    }
    EXPECT_GT(fills, 10u);
    dut.aclr_i = 1;
    dut.eval();
    EXPECT_TRUE(dut.empty_o);
}

TEST_F(Memories, ShowTheNextWordOfAFifoAhead) {
    dut.wrreq_i = 1;
    for (dut.data_i = 11; dut.data_i < 14; ++dut.data_i) write_clock();
    dut.wrreq_i = 0;
    write_clock();
    dut.rdreq_i = 1;
    for (unsigned word = 11; word < 14; ++word) {
        EXPECT_FALSE(dut.ahead_empty_o);
        EXPECT_EQ(dut.ahead_o, word);
        write_clock();
    }
    EXPECT_TRUE(dut.ahead_empty_o);
}

TEST_F(Memories, PassWordsFromOneClockToAnother) {
    std::deque<std::uint8_t> words;
    unsigned passed = 0;
    for (int i = 0; i < 5000; ++i) {
        dut.data_i = random() & 255;
        dut.wrreq_i = random() & 1;
        dut.rdreq_i = random() & 1;
        dut.eval();
        if (random() & 1) {
            if (dut.wrreq_i && !dut.dc_full_o) words.push_back(dut.data_i);
            write_clock();
            continue;
        }
        const bool reads = dut.rdreq_i && !dut.dc_empty_o;
        read_clock();
        if (!reads) continue;
        ASSERT_FALSE(words.empty());
        ASSERT_EQ(dut.dc_o, words.front());
        words.pop_front();
        ++passed;
    }
    EXPECT_GT(passed, 500u);
}

}  // namespace
