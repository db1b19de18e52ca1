// h2f_bridge.v and picture_store.v: the processor writes and reads back while the screen reads.
#include <gtest/gtest.h>

#include <map>
#include <random>

#include "Vpicture_bench.h"
#include "tb/support/axi_master.h"
#include "tb/support/random_registers.h"

namespace {

using namespace tb;

constexpr std::uint32_t PICTURE0 = 0x08000000, PICTURE1 = 0x00000000;  // offsets in the bridge

class Picture : public ::testing::Test {
protected:
    Vpicture_bench dut;
    AxiMaster<Vpicture_bench> axi{dut};
    std::uint64_t clocks = 0;
    bool screen = true;
    std::map<std::uint32_t, std::uint32_t> expected;  // bridge offset of a word -> its value

    // What the screen asked for a clock ago, and two.
    bool asked = false, kept = false;
    std::uint32_t asked_offset = 0;
    unsigned wrong_pixels = 0, checked_pixels = 0;
    std::uint32_t screen_offset = PICTURE0;

    static void SetUpTestSuite() { start_with_random_registers(); }

    void SetUp() override {
        dut.rst_i = 1;
        dut.awvalid_i = dut.wvalid_i = dut.arvalid_i = dut.screen_re_i = 0;
        dut.cell_re_i = dut.clear_i = dut.screen_keep_i = 0;
        clock();
        clock();
        dut.rst_i = 0;
        axi.forget();
    }

    void clock() {
        dut.clk_i = 0;
        axi.before_edge();
        if (asked || kept) {
            const auto wanted = expected.find(asked_offset);
            if (wanted != expected.end()) {
                ++checked_pixels;
                wrong_pixels += dut.screen_word_o != wanted->second;
            }
        }
        kept = asked;
        dut.screen_keep_i = kept;
        asked = screen && clocks % 4 == 0;
        dut.screen_re_i = asked;
        if (asked) asked_offset = screen_offset;
        dut.screen_index_i = (screen_offset < PICTURE0 ? 38400 : 0) +
                             (screen_offset >> 10 & 0xff) * 160 + (screen_offset >> 2 & 0xff);
        dut.eval();
        dut.clk_i = 1;
        dut.eval();
        axi.after_edge();
        ++clocks;
    }
    void finish() {
        for (int i = 0; i < 20000 && !axi.idle(); ++i) clock();
        ASSERT_TRUE(axi.idle()) << "the bridge did not answer";
    }
    std::uint32_t read(std::uint32_t address) {
        axi.forget();
        axi.read({1, address, 1, 2, INCR});
        finish();
        EXPECT_EQ(axi.beats[0].resp, OKAY);
        return axi.beats[0].data;
    }
    void write(std::uint32_t address, std::uint32_t value, std::uint8_t strobes = 0xf) {
        axi.forget();
        axi.write({1, address, 2, INCR, {value}, {strobes}});
        finish();
        EXPECT_EQ(axi.written[0].resp, OKAY);
    }
};

TEST_F(Picture, KeepsTheCornersOfBothPicturesApart) {
    const std::uint32_t corners[] = {0, 159 * 4, 239 << 10, (239 << 10) + 159 * 4};
    std::uint32_t value = 1;
    for (const std::uint32_t base : {PICTURE0, PICTURE1})
        for (const std::uint32_t corner : corners) write(base + corner, value++);
    value = 1;
    for (const std::uint32_t base : {PICTURE0, PICTURE1})
        for (const std::uint32_t corner : corners) EXPECT_EQ(read(base + corner), value++);
}

TEST_F(Picture, WritesSinglePixelsAndBytes) {
    write(PICTURE0 + 1024, 0);
    write(PICTURE0 + 1024, 0x0000abcd, 0x3);
    write(PICTURE0 + 1026, 0x12340000, 0xc);
    EXPECT_EQ(read(PICTURE0 + 1024), 0x1234abcdu);
    write(PICTURE0 + 1024, 0x00550000, 0x4);
    EXPECT_EQ(read(PICTURE0 + 1024), 0x1255abcdu);
    write(PICTURE0 + 1024, 0xffffffff, 0x0);
    EXPECT_EQ(read(PICTURE0 + 1024), 0x1255abcdu);
}

TEST_F(Picture, TakesWritesBetweenAndBehindTheRowsWithoutHarm) {
    write(PICTURE0, 0x22222222);
    write(PICTURE0 + 1024, 0x11111111);
    for (const std::uint32_t hole :
         {160u * 4, 255u * 4, 240u << 10, 0x3fffcu, 0x40000u, 0x7fffcu}) {
        write(PICTURE0 + hole, 0xdeadbeef);
        EXPECT_EQ(read(PICTURE0 + hole), 0u) << std::hex << hole;
    }
    EXPECT_EQ(read(PICTURE0), 0x22222222u);
    EXPECT_EQ(read(PICTURE0 + 1024), 0x11111111u);
}

TEST_F(Picture, AnswersOtherAddressesWithDecerr) {
    for (const std::uint32_t address :
         {0x00080000u, 0x04000000u, 0x07fffffcu, 0x08080000u, 0x3ffffffcu}) {
        axi.forget();
        axi.write({1, address, 2, INCR, {1}, {0xf}});
        axi.read({1, address, 1, 2, INCR});
        finish();
        EXPECT_EQ(axi.written[0].resp, DECERR) << std::hex << address;
        EXPECT_EQ(axi.beats[0].resp, DECERR) << std::hex << address;
    }
}

TEST_F(Picture, WritesABeatAClock) {
    axi.stall = 0;
    WriteRequest burst{1,
                       PICTURE0,
                       2,
                       INCR,
                       std::vector<std::uint32_t>(16, 7),
                       std::vector<std::uint8_t>(16, 0xf)};
    axi.write(burst);
    const std::uint64_t begin = clocks;
    finish();
    EXPECT_LE(clocks - begin, 16u + 5);
}

TEST_F(Picture, ReadsAWordInAtMostSevenClocksWhileTheScreenReads) {
    axi.stall = 0;
    for (std::uint32_t phase = 0; phase < 4; ++phase) {
        while (clocks % 4 != phase) clock();
        axi.forget();
        axi.read({1, PICTURE0, 16, 2, INCR});
        const std::uint64_t begin = clocks;
        finish();
        EXPECT_LE(clocks - begin, 16u * 7);
    }
}

// Random bursts with random strobes and pauses; the screen keeps reading words that are known.
TEST_F(Picture, GivesScreenAndProcessorTheRightWordsUnderRandomTraffic) {
    std::mt19937 random{7};
    for (std::uint32_t i = 0; i < 160; ++i) {  // row 0 of PICTURE0 is the screen's
        write(PICTURE0 + 4 * i, i * 0x01010101);
        expected[PICTURE0 + 4 * i] = i * 0x01010101;
    }
    for (int round = 0; round < 400; ++round) {
        axi.forget();
        axi.stall = static_cast<unsigned>(round % 3) * 30;
        screen_offset = PICTURE0 + 4 * (random() % 160);
        const auto beats = static_cast<std::uint8_t>(1 + random() % 16);
        const std::uint32_t base = random() % 2 ? PICTURE0 : PICTURE1;
        const auto row = static_cast<std::uint32_t>(1 + random() % 239);
        const std::uint32_t start = base + (row << 10) + 4 * (random() % (161 - beats));
        WriteRequest burst{3, start, 2, INCR, {}, {}};
        std::map<std::uint32_t, std::uint32_t> now;
        for (std::uint32_t i = 0; i < beats; ++i) {
            const std::uint32_t at = start + 4 * i;
            const auto strobes = static_cast<std::uint8_t>(expected.count(at) ? random() % 16 : 15);
            burst.data.push_back(static_cast<std::uint32_t>(random()));
            burst.strobes.push_back(strobes);
            std::uint32_t mask = 0;
            for (int lane = 0; lane < 4; ++lane)
                mask |= strobes >> lane & 1 ? 0xffu << 8 * lane : 0;
            now[at] = ((expected.count(at) ? expected[at] : 0) & ~mask) | (burst.data[i] & mask);
        }
        axi.write(burst);
        finish();
        for (const auto& [at, value] : now) expected[at] = value;
        axi.read({4, start, beats, 2, INCR});
        finish();
        for (std::uint32_t i = 0; i < beats; ++i)
            ASSERT_EQ(axi.beats[i].data, expected[start + 4 * i]) << "round " << round;
    }
    EXPECT_GT(checked_pixels, 1000u);
    EXPECT_EQ(wrong_pixels, 0u);
}

}  // namespace
