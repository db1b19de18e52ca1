// h2f_bridge.v and character_store.v: 80 x 60 characters written, read back, shown and cleared.
#include <gtest/gtest.h>

#include <random>
#include <vector>

#include "Vpicture_bench.h"
#include "tb/support/axi_master.h"
#include "tb/support/random_registers.h"

namespace {

using namespace tb;

constexpr std::uint32_t CHARACTERS = 0x09000000;  // offset in the bridge
constexpr std::uint32_t COLUMNS = 80, ROWS = 60;

class CharacterStore : public ::testing::Test {
protected:
    Vpicture_bench dut;
    AxiMaster<Vpicture_bench> axi{dut};
    std::uint64_t clocks = 0;

    static void SetUpTestSuite() { start_with_random_registers(); }

    void SetUp() override {
        dut.awvalid_i = dut.wvalid_i = dut.arvalid_i = 0;
        dut.screen_re_i = dut.screen_req_i = dut.cell_re_i = dut.clear_i = 0;
        reset();
        axi.forget();
        clear();
    }
    void reset() {
        dut.rst_i = 1;
        clock();
        clock();
        dut.rst_i = 0;
    }
    void clock() {
        dut.clk_i = 0;
        axi.before_edge();
        dut.eval();
        dut.clk_i = 1;
        dut.eval();
        axi.after_edge();
        ++clocks;
    }
    unsigned clear() {
        dut.clear_i = 1;
        clock();
        dut.clear_i = 0;
        unsigned count = 1;
        while (dut.clearing_o && ++count < 2000) clock();
        return count;
    }
    void finish() {
        for (int i = 0; i < 2000 && !axi.idle(); ++i) clock();
        ASSERT_TRUE(axi.idle()) << "the bridge did not answer";
    }
    std::uint32_t read(std::uint32_t offset) {
        axi.forget();
        axi.read({1, CHARACTERS + offset, 1, 2, INCR});
        finish();
        EXPECT_EQ(axi.beats[0].resp, OKAY);
        return axi.beats[0].data;
    }
    void write(std::uint32_t offset, std::uint32_t value, std::uint8_t strobes = 0xf) {
        axi.forget();
        axi.write({1, CHARACTERS + offset, 2, INCR, {value}, {strobes}});
        finish();
        EXPECT_EQ(axi.written[0].resp, OKAY);
    }
    // One character, as strb does.
    void put(std::uint32_t x, std::uint32_t y, std::uint8_t code) {
        write(y << 7 | (x & ~3u), 0x01010101u * code, static_cast<std::uint8_t>(1 << x % 4));
    }
    void fill() {
        for (std::uint32_t y = 0; y < ROWS; ++y)
            for (std::uint32_t word = 0; word < COLUMNS / 4; ++word) write(y << 7 | word << 2, ~0u);
    }
    // Writes some characters, the first at once and the others in the next 2,000 clocks or so, and
    // looks at all of them: those are kept and the others are `blank`.
    void expect_kept_what_is_written(unsigned seed, std::uint32_t blank) {
        std::mt19937 random{seed};
        std::vector<std::uint32_t> words(ROWS * COLUMNS / 4, blank);
        for (int i = 0; i < 6; ++i) {
            const auto at = static_cast<std::uint32_t>(random() % words.size());
            const auto value = static_cast<std::uint32_t>(random());
            const auto strobes = static_cast<std::uint8_t>(random() % 16);
            write(at / 20 << 7 | at % 20 << 2, value, strobes);
            for (unsigned lane = 0; lane < 4; ++lane)
                if (strobes >> lane & 1)
                    words[at] = (words[at] & ~(0xffu << 8 * lane)) | (value & 0xffu << 8 * lane);
            for (auto clocks_between = random() % 700; clocks_between--;) clock();
        }
        for (int i = 0; i < 2000; ++i) clock();
        for (std::uint32_t at = 0; at < words.size(); ++at)
            ASSERT_EQ(shown(at % 20, at / 20), words[at]) << seed << ": " << at;
    }
    // The word of four that the screen gets.
    std::uint32_t shown(std::uint32_t word, std::uint32_t row) {
        dut.screen_re_i = dut.cell_re_i = 1;
        dut.cell_index_i = static_cast<std::uint16_t>(row << 5 | word);
        clock();
        dut.screen_re_i = dut.cell_re_i = 0;
        return dut.cells_o;
    }
};

TEST_F(CharacterStore, KeepsEveryCharacterApart) {
    std::mt19937 random{3};
    std::vector<std::uint8_t> text(COLUMNS * ROWS);
    for (auto& code : text) code = static_cast<std::uint8_t>(random());
    for (std::uint32_t y = 0; y < ROWS; ++y)
        for (std::uint32_t x = 0; x < COLUMNS; ++x) put(x, y, text[y * COLUMNS + x]);
    for (std::uint32_t y = 0; y < ROWS; ++y)
        for (std::uint32_t word = 0; word < COLUMNS / 4; ++word) {
            std::uint32_t four = 0;
            for (unsigned i = 0; i < 4; ++i)
                four |= static_cast<std::uint32_t>(text[y * COLUMNS + 4 * word + i]) << 8 * i;
            ASSERT_EQ(read(y << 7 | word << 2), four) << word << "," << y;
            ASSERT_EQ(shown(word, y), four) << word << "," << y;
        }
}

TEST_F(CharacterStore, IsMemoryBesideTheScreenToo) {
    const std::uint32_t beside[] = {80, 124, 60u << 7, 0x1ffc};
    for (const std::uint32_t offset : beside) write(offset, 0xdead0000 | offset);
    for (const std::uint32_t offset : beside)
        EXPECT_EQ(read(offset), 0xdead0000 | offset) << std::hex << offset;
    for (std::uint32_t y = 0; y < ROWS; ++y)
        for (std::uint32_t word = 0; word < COLUMNS / 4; ++word)
            ASSERT_EQ(shown(word, y), 0x20202020u) << word << "," << y;
}

TEST_F(CharacterStore, IsNotChangedByWritesAfterIt) {
    write(0, 0x41414141);
    write(0x2000, 0x42424242);
    EXPECT_EQ(read(0), 0x41414141u);
}

TEST_F(CharacterStore, ClearsToBlanksIn1920Clocks) {
    fill();
    EXPECT_NEAR(clear(), 1920, 2);
    for (std::uint32_t y = 0; y < ROWS; ++y)
        for (std::uint32_t word = 0; word < COLUMNS / 4; ++word)
            ASSERT_EQ(shown(word, y), 0x20202020u) << word << "," << y;
}

TEST_F(CharacterStore, IsZeroAfterAReset) {
    fill();
    dut.rst_i = 1;
    clock();
    dut.rst_i = 0;
    EXPECT_EQ(dut.clearing_o, 0);
    for (int i = 0; i < 1921; ++i) clock();
    EXPECT_EQ(read(0), 0u);
    EXPECT_EQ(shown(0, 0), 0u);
    EXPECT_EQ(shown(19, 59), 0u);
    EXPECT_EQ(dut.any_o, 0);
}

TEST_F(CharacterStore, ReportsWritesOtherThanBlanksSinceTheClear) {
    EXPECT_EQ(dut.any_o, 0);
    write(0, 0x20202020);
    write(4, 0x41414141, 0);
    EXPECT_EQ(dut.any_o, 0);
    put(79, 59, 'A');
    EXPECT_EQ(dut.any_o, 1);
    put(79, 59, ' ');
    EXPECT_EQ(dut.any_o, 1);
    clear();
    EXPECT_EQ(dut.any_o, 0);
}

TEST_F(CharacterStore, KeepsWritesFromTheFirstClockAfterAReset) {
    for (unsigned round = 0; round < 40; ++round) {
        fill();
        reset();
        expect_kept_what_is_written(round, 0);
    }
}

TEST_F(CharacterStore, KeepsWritesFromTheFirstClockAfterAClear) {
    for (unsigned round = 0; round < 40; ++round) {
        fill();
        dut.clear_i = 1;
        clock();
        dut.clear_i = 0;
        expect_kept_what_is_written(round, 0x20202020);
    }
}

TEST_F(CharacterStore, ReadsZerosAndWritesFromTheFirstClockAfterAReset) {
    const std::uint32_t last = (ROWS - 1) << 7 | 4 * (COLUMNS / 4 - 1);
    fill();
    reset();
    EXPECT_EQ(read(last), 0u);
    fill();
    reset();
    write(last, 0x44434241, 0x6);
    EXPECT_EQ(read(last), 0x00434200u);
}

TEST_F(CharacterStore, LetsABurstWaitDuringAClear) {
    fill();
    axi.forget();
    WriteRequest burst{1, CHARACTERS + (59 << 7), 2, INCR, {}, {}};
    for (std::uint32_t i = 0; i < 16; ++i)
        burst.data.push_back(0x41414141), burst.strobes.push_back(0xf);
    axi.write(burst);
    for (int i = 0; i < 8; ++i) clock();
    dut.clear_i = 1;
    clock();
    dut.clear_i = 0;
    EXPECT_FALSE(axi.idle());
    finish();
    EXPECT_EQ(shown(0, 59), 0x20202020u) << "written before";
    EXPECT_EQ(shown(15, 59), 0x41414141u) << "written after";
}

TEST_F(CharacterStore, KeepsNoPictureWaitingWhileItClears) {
    const auto picture = [this] {
        axi.forget();
        axi.write({1, 0x08000000, 2, INCR, {0x12345678}, {0xf}});
        axi.read({1, 0x08000000, 1, 2, INCR});
        const std::uint64_t begin = clocks;
        finish();
        return clocks - begin;
    };
    const std::uint64_t took = picture();
    EXPECT_LT(took, 20u);
    reset();
    EXPECT_EQ(picture(), took);
}

}  // namespace
