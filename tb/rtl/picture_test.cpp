// h2f_bridge.v and the memories: the processor writes and reads back while the screen reads.
#include <gtest/gtest.h>

#include <algorithm>
#include <deque>
#include <map>
#include <random>

#include "Vpicture_bench.h"
#include "sim/board/is42s16320d.h"
#include "tb/support/axi_master.h"
#include "tb/support/random_registers.h"

namespace {

using namespace tb;

constexpr std::uint32_t ONCHIP = 0x08000000, SDRAM = 0x00000000;  // offsets in the bridge
constexpr std::uint64_t HALF_CLOCK_PS = 20'000;

class Picture : public ::testing::Test {
protected:
    Vpicture_bench dut;
    AxiMaster<Vpicture_bench> axi{dut};
    std::uint64_t clocks = 0;
    bool screen = true;
    std::map<std::uint32_t, std::uint32_t> expected;  // bridge offset of a word -> its value

    // What the screen asked the on-chip memory for a clock ago.
    bool asked = false;
    std::uint32_t asked_offset = 0;
    unsigned wrong_pixels = 0, checked_pixels = 0;
    std::uint32_t screen_offset = ONCHIP;

    sim::Is42s16320d chip;
    bool sdram_screen = false;  // the screen wants a row of the SDRAM in 1,600 clocks
    unsigned row_left = 0;      // words of it
    std::uint32_t sdram_next = 0;
    std::deque<std::uint32_t> sdram_asked;
    unsigned waited = 0, longest = 0;  // clocks until a request of the screen's is taken

    static void SetUpTestSuite() { start_with_random_registers(); }

    void SetUp() override {
        dut.rst_i = 1;
        dut.awvalid_i = dut.wvalid_i = dut.arvalid_i = dut.screen_re_i = 0;
        dut.cell_re_i = dut.clear_i = dut.screen_req_i = 0;
        clock();
        clock();
        dut.rst_i = 0;
        axi.forget();
    }
    void TearDown() override {
        EXPECT_EQ(chip.violations(), 0u)
            << (chip.messages().empty() ? "" : chip.messages().front());
    }

    // DRAM_CLK rises in the middle of a clock.
    void chip_sees_its_pins() {
        chip.clock(
            {dut.dram_cs_no != 0, dut.dram_ras_no != 0, dut.dram_cas_no != 0, dut.dram_we_no != 0,
             dut.dram_ba_o, dut.dram_addr_o, dut.dram_dqm_o, dut.dram_dq_oe_o != 0, dut.dram_dq_o},
            clocks * 2 * HALF_CLOCK_PS + HALF_CLOCK_PS);
        dut.dram_dq_i = chip.dq();
    }

    // The screen's reads of the SDRAM, answered in the order of the requests.
    void screen_reads_sdram() {
        if (dut.screen_valid_o && !sdram_asked.empty()) {
            const auto wanted = expected.find(sdram_asked.front());
            sdram_asked.pop_front();
            ++checked_pixels;
            wrong_pixels += wanted == expected.end() || dut.sdram_word_o != wanted->second;
        }
        if (clocks % 1600 == 0) row_left = 161;
        dut.screen_req_i = sdram_screen && row_left;
        dut.screen_sdram_index_i = sdram_next / 4;
        dut.eval();
        waited = dut.screen_req_i && !dut.screen_take_o ? waited + 1 : 0;
        longest = std::max(longest, waited);
        if (!dut.screen_take_o) return;
        --row_left;
        sdram_asked.push_back(sdram_next);
        sdram_next = (sdram_next + 4) % 640;
    }

    void clock() {
        dut.clk_i = 0;
        axi.before_edge();
        if (asked) {
            const auto wanted = expected.find(asked_offset);
            if (wanted != expected.end()) {
                ++checked_pixels;
                wrong_pixels += dut.screen_word_o != wanted->second;
            }
        }
        screen_reads_sdram();
        asked = screen && clocks % 2 == 0;
        dut.screen_re_i = asked;
        if (asked) asked_offset = screen_offset;
        dut.screen_index_i = screen_offset >> 2 & 0xffff;
        dut.eval();
        dut.clk_i = 1;
        dut.eval();
        chip_sees_its_pins();
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

TEST_F(Picture, KeepsEveryCornerOfBothMemoriesApart) {
    const std::uint32_t onchip[] = {0, 640, 0x3fc, 0x3c000, 0x3fffc},
                        dram[] = {0, 0x7fc, 0x800, 0x40000, 0x80000, 0x2000000, 0x3fffffc};
    std::uint32_t value = 1;
    for (const std::uint32_t at : onchip) write(ONCHIP + at, value++);
    for (const std::uint32_t at : dram) write(SDRAM + at, value++);
    value = 1;
    for (const std::uint32_t at : onchip) EXPECT_EQ(read(ONCHIP + at), value++);
    for (const std::uint32_t at : dram) EXPECT_EQ(read(SDRAM + at), value++);
    EXPECT_EQ(chip.bytes()[0x3fffffc], value - 1);  // where the chip's description says
}

TEST_F(Picture, SendsAddressesWithoutAMemoryToTheSdram) {
    write(ONCHIP, 0x22222222);
    write(ONCHIP + 0x3fffc, 0x11111111);
    for (const std::uint32_t address :
         {0x04000010u, 0x07fffffcu, 0x08040000u, 0x0807fffcu, 0x09002000u}) {
        write(address, address ^ 0xdeadbeef);
        EXPECT_EQ(read(SDRAM + (address & 0x3ffffff)), address ^ 0xdeadbeef) << std::hex << address;
    }
    EXPECT_EQ(read(ONCHIP), 0x22222222u);
    EXPECT_EQ(read(ONCHIP + 0x3fffc), 0x11111111u);
}

TEST_F(Picture, RepeatsTheMemoriesEach256Megabytes) {
    write(0x10000000 + ONCHIP, 0x33333333);
    write(0x30000004, 0x44444444);
    EXPECT_EQ(read(ONCHIP), 0x33333333u);
    EXPECT_EQ(read(SDRAM + 4), 0x44444444u);
}

TEST_F(Picture, WritesABeatPerClockToTheOnChipMemory) {
    axi.stall = 0;
    WriteRequest burst{
        1, ONCHIP, 2, INCR, std::vector<std::uint32_t>(16, 7), std::vector<std::uint8_t>(16, 0xf)};
    axi.write(burst);
    const std::uint64_t begin = clocks;
    finish();
    EXPECT_LE(clocks - begin, 16u + 5);
}

TEST_F(Picture, WritesABeatInTwoClocksToAnOpenRow) {
    axi.stall = 0;
    read(SDRAM);  // the initialisation is over, the row is open
    axi.forget();
    axi.write(
        {1, SDRAM, 2, INCR, std::vector<std::uint32_t>(16, 7), std::vector<std::uint8_t>(16, 0xf)});
    const std::uint64_t begin = clocks;
    finish();
    EXPECT_LE(clocks - begin, 2u * 16 + 8);
}

TEST_F(Picture, ReadsAWordOfTheSdramInNineClocks) {
    axi.stall = 0;
    read(SDRAM);
    axi.forget();
    axi.read({1, SDRAM, 16, 2, INCR});
    const std::uint64_t begin = clocks;
    finish();
    EXPECT_LE(clocks - begin, 16u * 9 + 6);
}

TEST_F(Picture, ReadsAWordWithinSevenClocksBesideTheScreen) {
    axi.stall = 0;
    for (std::uint32_t phase = 0; phase < 4; ++phase) {
        while (clocks % 4 != phase) clock();
        axi.forget();
        axi.read({1, ONCHIP, 16, 2, INCR});
        const std::uint64_t begin = clocks;
        finish();
        EXPECT_LE(clocks - begin, 16u * 7);
    }
}

// Random bursts with random strobes and pauses; the screen keeps reading words that are known.
TEST_F(Picture, GivesScreenAndProcessorTheRightWordsUnderRandomTraffic) {
    std::mt19937 random{7};
    for (const std::uint32_t memory : {ONCHIP, SDRAM})  // their rows 0 are the screen's
        for (std::uint32_t i = 0; i < 160; ++i) {
            write(memory + 4 * i, i * 0x01010101);
            expected[memory + 4 * i] = i * 0x01010101;
        }
    for (int round = 0; round < 400; ++round) {
        axi.forget();
        axi.stall = static_cast<unsigned>(round % 3) * 30;
        screen_offset = ONCHIP + 4 * (random() % 160);
        const auto beats = static_cast<std::uint8_t>(1 + random() % 16);
        sdram_screen = random() % 2;
        const std::uint32_t base = random() % 2 ? ONCHIP : SDRAM + (random() % 8 << 22);
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
    EXPECT_GT(longest, 0u);
    EXPECT_LE(longest, 16u) << "clocks that the SDRAM let the screen wait";
}

}  // namespace
