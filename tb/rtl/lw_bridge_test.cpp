// lw_bridge.v (with axi_write.v and axi_read.v): AXI3 at the front, a register file at the back.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <random>

#include "Vlw_bridge.h"
#include "regmap.h"
#include "tb/support/axi_master.h"
#include "tb/support/random_registers.h"

namespace {

using namespace tb;

constexpr std::uint32_t LEDR = regmap::LEDR_DATA & 0x1fffff;
constexpr std::uint32_t KEYPAD = regmap::KEYPAD_BASE & 0x1fffff;
constexpr std::uint32_t TIMER0_LINE = 1u << 12;  // restated: the 13th block of the bridge

class LwBridge : public ::testing::Test {
protected:
    Vlw_bridge dut;
    AxiMaster<Vlw_bridge> axi{dut};
    std::map<std::uint64_t, std::uint32_t> words;  // block << 12 | address
    std::vector<std::uint32_t> write_order, read_order, lines_read;
    std::vector<bool> low_reads;
    std::vector<std::uint32_t> lines_written;
    std::uint32_t late_answer = 0;  // of a block that was waited for
    std::uint32_t rdata = 0;

    static void SetUpTestSuite() { start_with_random_registers(); }

    void SetUp() override {
        dut.rst_i = 1;
        dut.awvalid_i = dut.wvalid_i = dut.arvalid_i = dut.hold_i = dut.rhold_i = 0;
        clock();
        clock();
        dut.rst_i = 0;
        axi.forget();
        write_order.clear();
        read_order.clear();
        low_reads.clear();
        lines_read.clear();
        lines_written.clear();
    }

    void clock() {
        dut.clk_i = 0;
        axi.before_edge();
        std::uint32_t answer = 0;
        if (!dut.rst_i) {
            EXPECT_EQ(dut.we_o & (dut.we_o - 1), 0) << "more than one block is written";
            EXPECT_EQ(dut.re_o & (dut.re_o - 1), 0) << "more than one block is read";
        }
        if (dut.re_o) {
            const std::uint64_t at = std::uint64_t{dut.re_o} << 12 | dut.raddr_o;
            read_order.push_back(dut.raddr_o);
            low_reads.push_back(dut.rlow_o);
            lines_read.push_back(dut.re_o);
            answer = words[at];
        }
        if (dut.we_o) {
            std::uint32_t& word = words[std::uint64_t{dut.we_o} << 12 | dut.waddr_o];
            for (int lane = 0; lane < 4; ++lane)
                if (dut.wstrb_o >> lane & 1) {
                    const std::uint32_t mask = 0xffu << 8 * lane;
                    word = (word & ~mask) | (dut.wdata_o & mask);
                }
            write_order.push_back(dut.waddr_o);
            lines_written.push_back(dut.we_o);
        }
        dut.clk_i = 1;
        dut.eval();
        dut.rdata_i = answer | late_answer;  // as a block would: registered, 0 unless asked
        late_answer = 0;
        axi.after_edge();
    }

    void finish() {
        for (int i = 0; i < 20000 && !axi.idle(); ++i) clock();
        ASSERT_TRUE(axi.idle()) << "the bridge did not answer";
    }
};

TEST_F(LwBridge, WritesOnlyTheBytesThatTheStrobesName) {
    axi.write({1, LEDR, 2, INCR, {0xaaaaaaaa}, {0xf}});
    axi.write({1, LEDR + 1, 0, INCR, {0x0000bb00}, {0x2}});
    axi.write({1, LEDR + 2, 1, INCR, {0xccdd0000}, {0xc}});
    axi.read({1, LEDR, 1, 2, INCR});
    finish();
    axi.read({1, LEDR, 1, 2, INCR});
    finish();
    EXPECT_EQ(axi.beats.back().data, 0xccddbbaau);
}

TEST_F(LwBridge, WalksThroughABurst) {
    WriteRequest burst{3, KEYPAD, 2, INCR, {}, {}};
    for (std::uint32_t i = 0; i < 8; ++i)
        burst.data.push_back(100 + i), burst.strobes.push_back(0xf);
    axi.write(burst);
    finish();
    axi.read({3, KEYPAD, 8, 2, INCR});
    finish();
    ASSERT_EQ(axi.beats.size(), 8u);
    for (std::uint32_t i = 0; i < 8; ++i) {
        EXPECT_EQ(write_order[i], (KEYPAD & 0xfff) + 4 * i);
        EXPECT_EQ(axi.beats[i].data, 100 + i);
        EXPECT_EQ(axi.beats[i].last, i == 7);
    }
}

TEST_F(LwBridge, AlignsTheSecondBeatOfAnUnalignedBurst) {
    axi.read({1, KEYPAD + 2, 3, 2, INCR});
    axi.read({1, KEYPAD + 1, 4, 0, INCR});
    axi.read({1, KEYPAD + 2, 3, 1, INCR});
    finish();
    const std::uint32_t k = KEYPAD & 0xfff;
    EXPECT_EQ(read_order, (std::vector<std::uint32_t>{k, k + 4, k + 8,     // words
                                                      k, k, k, k + 4,      // bytes 1, 2, 3, 4
                                                      k, k + 4, k + 4}));  // half-words 2, 4, 6
}

TEST_F(LwBridge, AlignsTheSecondBeatOfAnUnalignedWrite) {
    axi.write({1, KEYPAD + 2, 2, INCR, {0, 0, 0}, {0xc, 0xf, 0xf}});
    axi.write({1, KEYPAD + 1, 0, INCR, {0, 0, 0, 0}, {0x2, 0x4, 0x8, 0x1}});
    axi.write({1, KEYPAD + 3, 1, INCR, {0, 0, 0}, {0x8, 0x3, 0xc}});
    finish();
    const std::uint32_t k = KEYPAD & 0xfff;
    EXPECT_EQ(write_order,
              (std::vector<std::uint32_t>{k, k + 4, k + 8,     // words
                                          k, k, k, k + 4,      // bytes 1, 2, 3, 4
                                          k, k + 4, k + 4}));  // byte 3, half-words 4, 6
}

TEST_F(LwBridge, WaitsForABlockThatCannotAnswerYet) {
    dut.rhold_i = 1;
    axi.read({8, LEDR, 1, 2, INCR});
    for (int i = 0; i < 50; ++i) clock();
    EXPECT_TRUE(axi.beats.empty());
    EXPECT_EQ(read_order.size(), 1u) << "asked once";
    dut.rhold_i = 0;
    late_answer = 77;  // in the clock after
    for (int i = 0; i < 4; ++i) clock();
    ASSERT_EQ(axi.beats.size(), 1u);
    EXPECT_EQ(axi.beats[0].data, 77u);
}

TEST_F(LwBridge, HoldsTheResponseWhileTheBlockIsNotDone) {
    dut.hold_i = 1;
    axi.write({6, LEDR, 2, INCR, {1}, {0xf}});
    for (int i = 0; i < 100; ++i) clock();
    EXPECT_EQ(write_order.size(), 1u);
    EXPECT_TRUE(axi.written.empty());
    axi.read({9, LEDR, 1, 2, INCR});
    for (int i = 0; i < 20; ++i) clock();
    EXPECT_EQ(axi.beats.size(), 1u) << "reads go on";
    dut.hold_i = 0;
    for (int i = 0; i < 3; ++i) clock();
    ASSERT_EQ(axi.written.size(), 1u);
    EXPECT_EQ(axi.written[0].id, 6);
    EXPECT_EQ(axi.written[0].resp, OKAY);
}

TEST_F(LwBridge, ReportsWhetherTheLowestByteIsRead) {
    axi.read({1, KEYPAD, 1, 2, INCR});
    axi.read({1, KEYPAD, 4, 0, INCR});
    axi.read({1, KEYPAD + 2, 3, 1, INCR});
    finish();
    EXPECT_EQ(low_reads, (std::vector<bool>{true, true, false, false, false, false, true, false}));
}

TEST_F(LwBridge, ReadsWhileAWriteWaitsForItsData) {
    axi.hold_data = true;
    axi.write({1, LEDR, 2, INCR, {1}, {0xf}});
    axi.read({1, LEDR, 1, 2, INCR});
    for (int i = 0; i < 20; ++i) clock();
    EXPECT_EQ(axi.beats.size(), 1u);
    EXPECT_EQ(axi.written.size(), 0u);
    axi.hold_data = false;
    finish();
    EXPECT_EQ(axi.written[0].resp, OKAY);
}

// The select line of the block that has this address in regmap.def, else that of the first timer;
// so is a write to a block that can only be read.
std::uint32_t line_of(std::uint32_t offset, bool write) {
    std::uint32_t line = 1;
    for (const auto& block : regmap::BLOCKS) {
        if (block.base < 0xFF200000) continue;
        const bool only_read = block.base == regmap::SW_BASE || block.base == regmap::SYSID_BASE ||
                               block.base == regmap::RESAMPLER_BASE;
        if (0xFF200000 + offset % 0x8000 - block.base < block.size)
            return write && only_read ? TIMER0_LINE : line;
        line <<= 1;
    }
    return TIMER0_LINE;
}

TEST_F(LwBridge, SelectsExactlyTheBlockOfEachAddress) {
    for (std::uint32_t begin = 0; begin < 0x10000; begin += 64) {
        lines_read.clear();
        lines_written.clear();
        axi.forget();
        axi.write({7, begin, 2, INCR, std::vector<std::uint32_t>(16),
                   std::vector<std::uint8_t>(16, 0xf)});
        axi.read({1, begin, 16, 2, INCR});
        finish();
        EXPECT_EQ(axi.written[0].resp, OKAY);
        EXPECT_EQ(axi.written[0].id, 7);
        std::vector<std::uint32_t> to_read, to_write;
        for (std::uint32_t at = begin; at < begin + 64; at += 4) {
            ASSERT_EQ(axi.beats[(at - begin) / 4].resp, OKAY) << std::hex << at;
            to_read.push_back(line_of(at, false));
            to_write.push_back(line_of(at, true));
        }
        ASSERT_EQ(lines_read, to_read) << "from " << std::hex << begin;
        ASSERT_EQ(lines_written, to_write) << "from " << std::hex << begin;
    }
}

}  // namespace
