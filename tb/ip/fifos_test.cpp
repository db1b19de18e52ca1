// scfifo, dcfifo and dcfifo_mixed_widths, by Intel's "FIFO Intel FPGA IP User Guide" (683522).

#include "Vfifos_bench.h"

#include <gmock/gmock.h>

#include <deque>
#include <random>

namespace {

class Fifo : public testing::Test {
protected:
    static constexpr unsigned WRITE = 1, READ = 2;  // clocks

    Fifo() { dut.eval(); }

    void clock(unsigned which = WRITE) {
        if (which & WRITE) dut.clock_i = 1;
        if (which & READ) dut.rdclk_i = 1;
        dut.eval();
        dut.clock_i = dut.rdclk_i = 0;
        dut.eval();
    }

    void write(unsigned data) {
        dut.data_i = data;
        dut.wrreq_i = 1;
        clock();
        dut.wrreq_i = 0;
    }

    void read(unsigned which) {
        dut.rdreq_i = 1;
        clock(which);
        dut.rdreq_i = 0;
    }

    // Clocks after which `flag` holds.
    template <class Flag>
    unsigned until(unsigned which, const Flag& flag) {
        unsigned clocks = 0;
        for (; clocks < 20 && !flag(); ++clocks) clock(which);
        return clocks;
    }

    Vfifos_bench dut;
};

TEST_F(Fifo, ShowsAWriteAfterTheClocksOfTheGuide) {
    EXPECT_EQ(dut.empty_o, 7);
    write(0x42);
    EXPECT_EQ(dut.normal_used_o, 1);
    EXPECT_EQ(dut.empty_o, 2);
    EXPECT_EQ(dut.cells_o, 0x42);
    clock();
    EXPECT_EQ(dut.empty_o, 2);
    clock();
    EXPECT_EQ(dut.empty_o, 0);
    EXPECT_EQ(dut.ahead_o, 0x42);
    EXPECT_EQ(dut.normal_o, 0);
    read(WRITE);
    EXPECT_EQ(dut.empty_o, 7);
    EXPECT_EQ(dut.normal_used_o, 0);
    EXPECT_EQ(dut.normal_o, 0x42);
}

TEST_F(Fifo, CountsItsWords) {
    EXPECT_TRUE(dut.almost_empty_o & 1);
    for (unsigned i = 1; i <= 8; ++i) {
        write(i);
        EXPECT_EQ(dut.normal_used_o, i % 8);  // of eight words in three bits
        EXPECT_EQ(dut.almost_empty_o & 1, i < 2);
        EXPECT_EQ(dut.almost_full_o & 1, i >= 6);
        EXPECT_EQ(dut.full_o & 1, i == 8);
        EXPECT_EQ(dut.full_o >> 1 & 1, i >= 5);
        EXPECT_EQ(dut.full_o >> 2 & 1, i >= 4);
    }
}

TEST_F(Fifo, IgnoresAWriteWhenFullWithoutARead) {
    for (unsigned i = 1; i <= 9; ++i) write(i);
    dut.rdreq_i = 1;
    write(10);
    EXPECT_EQ(dut.full_o, 2);
    clock();
    EXPECT_EQ(dut.normal_o, 2);
    for (unsigned i = 3; i <= 6; ++i) {
        EXPECT_EQ(dut.ahead_o, i < 6 ? i : 10);
        clock();
    }
    EXPECT_TRUE(dut.empty_o & 2);
    EXPECT_EQ(dut.normal_o, 6);
    for (int i = 0; i < 5; ++i) clock();
    EXPECT_EQ(dut.normal_o, 8);
    EXPECT_EQ(dut.normal_used_o, 0);
}

TEST_F(Fifo, IsEmptiedByEitherClear) {
    for (unsigned i = 1; i <= 4; ++i) write(i);
    dut.aclr_i = 1;
    dut.eval();
    EXPECT_EQ(dut.empty_o, 7);
    EXPECT_EQ(dut.rdempty_o, 15);
    EXPECT_EQ(dut.wrempty_o, 15);
    dut.aclr_i = 0;
    for (unsigned i = 1; i <= 4; ++i) write(i);
    dut.sclr_i = 1;
    dut.eval();
    EXPECT_EQ(dut.empty_o, 0);
    clock();
    EXPECT_EQ(dut.empty_o, 7);
    dut.sclr_i = 0;
    write(5);
    clock();
    clock();
    EXPECT_EQ(dut.cells_o, 5);
    EXPECT_EQ(dut.ahead_o, 5);
}

TEST_F(Fifo, KeepsTheOrderOfRandomWritesAndReads) {
    std::mt19937 random{1};
    std::deque<unsigned> normal, ahead, cells, two, two_ahead;
    for (int i = 0; i < 5000; ++i) {
        const bool fill = i / 100 % 2;
        dut.data_i = random() & 0xFF;
        dut.wrreq_i = random() % 4 < (fill ? 3 : 1);
        dut.rdreq_i = random() % 4 < (fill ? 1 : 3);
        dut.eval();
        const unsigned clocks = random() % 3 + 1;
        if (clocks & WRITE) {
            ASSERT_EQ(dut.normal_used_o, normal.size() % 8);
            const auto take = [&](std::deque<unsigned>& words, unsigned bit, unsigned q) {
                if (!dut.rdreq_i || dut.empty_o >> bit & 1) return;
                EXPECT_EQ(q, words.front()) << "FIFO " << bit << ", step " << i;
                words.pop_front();
            };
            const bool room = dut.rdreq_i && !(dut.empty_o & 2);
            const bool put_ahead = dut.wrreq_i && (!(dut.full_o & 2) || room);
            if (dut.wrreq_i && !(dut.full_o & 1)) normal.push_back(dut.data_i);
            if (put_ahead) ahead.push_back(dut.data_i);
            if (dut.wrreq_i && !(dut.full_o & 4)) cells.push_back(dut.data_i);
            if (dut.wrreq_i && !(dut.wrfull_o & 1)) two.push_back(dut.data_i);
            if (dut.wrreq_i && !(dut.wrfull_o & 2)) two_ahead.push_back(dut.data_i);
            take(ahead, 1, dut.ahead_o);
            take(cells, 2, dut.cells_o);
        }
        const bool one = clocks & WRITE && dut.rdreq_i && !(dut.empty_o & 1);
        const bool other = clocks & READ && dut.rdreq_i && !(dut.rdempty_o & 1);
        if (clocks & READ && dut.rdreq_i && !(dut.rdempty_o & 2)) {
            ASSERT_EQ(dut.two_ahead_o, two_ahead.front());
            two_ahead.pop_front();
        }
        clock(clocks);
        if (one) {
            ASSERT_EQ(dut.normal_o, normal.front());
            normal.pop_front();
        }
        if (other) {
            ASSERT_EQ(dut.two_o, two.front());
            two.pop_front();
        }
        ASSERT_LE(two.size(), 8u);
    }
}

TEST_F(Fifo, CarriesAWriteAcrossInTheClocksOfTheGuide) {
    write(0x42);
    EXPECT_EQ(dut.wrempty_o & 3, 0);
    EXPECT_EQ(dut.two_wrused_o, 0);
    for (int i = 0; i < 5; ++i) clock(READ);
    EXPECT_EQ(dut.rdempty_o & 3, 3);  // two edges of wrclk it takes
    clock(WRITE);
    EXPECT_EQ(dut.two_wrused_o, 1);
    EXPECT_EQ(until(READ, [&] { return !(dut.rdempty_o & 1); }), 2u);
    EXPECT_EQ(dut.rdempty_o & 3, 2);  // the other one has three stages
    EXPECT_EQ(dut.two_rdused_o, 0);
    clock(READ);
    EXPECT_EQ(dut.rdempty_o & 3, 0);
    EXPECT_EQ(dut.two_rdused_o, 1);
    EXPECT_EQ(dut.two_ahead_o, 0x42);
}

TEST_F(Fifo, CarriesAReadBackInTheClocksOfTheGuide) {
    write(0x42);
    clock();
    for (int i = 0; i < 4; ++i) clock(READ);
    read(READ);
    EXPECT_EQ(dut.two_o, 0x42);
    EXPECT_EQ(dut.rdempty_o & 3, 3);
    EXPECT_EQ(dut.two_rdused_o, 1);
    clock(READ);
    EXPECT_EQ(dut.two_rdused_o, 0);
    EXPECT_EQ(until(WRITE, [&] { return (dut.wrempty_o & 1) == 1; }), 3u);
    EXPECT_EQ(dut.two_wrused_o, 1);
    clock(WRITE);
    EXPECT_EQ(dut.two_wrused_o, 0);
}

TEST_F(Fifo, CountsAFullFifoOfTwoClocks) {
    for (unsigned i = 1; i <= 10; ++i) write(i);
    clock();
    EXPECT_EQ(dut.wrfull_o & 3, 3);
    EXPECT_EQ(dut.two_wrused_o, 8);
    for (int i = 0; i < 5; ++i) clock(READ);
    EXPECT_EQ(dut.rdfull_o & 3, 3);
    EXPECT_EQ(dut.two_rdused_o, 8);
    for (unsigned i = 1; i <= 8; ++i) {
        read(READ);
        EXPECT_EQ(dut.two_o, i);
    }
    EXPECT_EQ(dut.rdempty_o & 3, 3);
}

TEST_F(Fifo, MakesAWideWordOfNarrowOnesTheFirstLowest) {
    for (unsigned i = 1; i <= 7; ++i) write(i);
    clock();
    for (int i = 0; i < 4; ++i) clock(READ);
    EXPECT_EQ(dut.widen_wrused_o, 7);
    EXPECT_EQ(dut.widen_rdused_o, 1);
    read(READ);
    EXPECT_EQ(dut.widen_o, 0x04030201u);
    EXPECT_TRUE(dut.rdempty_o & 4);
    for (int i = 0; i < 4; ++i) clock(WRITE);
    EXPECT_EQ(dut.widen_wrused_o, 3);
    write(8);
    clock();
    for (int i = 0; i < 4; ++i) clock(READ);
    read(READ);
    EXPECT_EQ(dut.widen_o, 0x08070605u);
}

TEST_F(Fifo, TakesAWideWordApartLowestFirst) {
    write(0x04030201);
    write(0x08070605);
    write(0x0C0B0A09);  // for which there is no room
    EXPECT_TRUE(dut.wrfull_o & 8);
    for (int i = 0; i < 4; ++i) clock(READ);
    EXPECT_EQ(dut.narrow_rdused_o, 8);
    EXPECT_TRUE(dut.rdfull_o & 8);
    for (unsigned i = 1; i <= 8; ++i) {
        EXPECT_FALSE(dut.rdempty_o & 8);
        EXPECT_EQ(dut.narrow_o, i);
        read(READ);
        for (int j = 0; j < 4; ++j) clock(WRITE);
        EXPECT_EQ(dut.narrow_wrused_o, i < 4 ? 2 : i < 8 ? 1 : 0);
    }
    EXPECT_TRUE(dut.rdempty_o & 8);
}

}  // namespace
