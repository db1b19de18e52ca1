// vga.v: registers, swap and pixels; the test is the picture store and looks at the ADV7123's pins.
#include <array>
#include <string>
#include <vector>

#include "Vvga.h"
#include "gfx/font.h"
#include "regmap.h"
#include "tb/support/register_bus.h"

namespace {

using namespace regmap;

constexpr int LINE = 800, LINES = 525, FRAME = LINE * LINES;

class Vga : public tb::RegisterBus<Vvga> {
protected:
    struct Pins {
        bool hs, vs, blank_n;
        std::uint32_t rgb;
    };
    std::array<std::vector<std::uint32_t>, 2> picture{std::vector<std::uint32_t>(38400),
                                                      std::vector<std::uint32_t>(38400)};
    std::vector<Pins> seen;
    std::array<std::uint8_t, 80 * 60> text{};
    std::uint32_t word = 0, cells = 0;
    unsigned fetches = 0, cell_fetches = 0;

    void SetUp() override {
        dut.resampler_re_i = dut.text_we_i = dut.text_re_i = dut.clearing_i = 0;
        dut.cells_any_i = 1;
        reset();
    }

    void after_clock() override {
        dut.word_i = word;  // asked for a clock ago
        dut.cells_i = cells;
        cells = 0x41414141;  // holds only for the clock after the fetch
        if (dut.cell_o) {
            ++cell_fetches;
            ASSERT_TRUE(dut.fetch_o) << "the processor may read now";
            const unsigned at = (dut.cell_index_o >> 5) * 80 + (dut.cell_index_o & 31) * 4;
            ASSERT_LT(at, text.size());
            cells = text[at] | text[at + 1] << 8 | text[at + 2] << 16 |
                    static_cast<std::uint32_t>(text[at + 3]) << 24;
        }
        if (dut.fetch_o) {
            ++fetches;
            ASSERT_LT(dut.index_o, 76800u);
            word = picture[dut.index_o / 38400][dut.index_o % 38400];
        } else {
            word = 0xdeadbeef;  // holds only for the clock after the fetch
        }
        seen.push_back(
            {dut.vga_hs_no != 0, dut.vga_vs_no != 0, dut.vga_blank_no != 0,
             static_cast<std::uint32_t>(dut.vga_r_o << 16 | dut.vga_g_o << 8 | dut.vga_b_o)});
    }

    // Runs to the end of the frame on screen and returns the 640 x 480 shown after the next one.
    std::vector<std::uint32_t> shown() {
        while (!(dut.vga_vs_no == 0)) clock();
        while (dut.vga_vs_no == 0) clock();
        seen.clear();
        clock(FRAME);
        std::vector<std::uint32_t> pixels;
        for (const Pins& p : seen)
            if (p.blank_n) pixels.push_back(p.rgb);
        return pixels;
    }

    void write_text(std::uint32_t address, std::uint32_t value) {
        dut.text_we_i = 1;
        dut.waddr_i = address & 0xfff;
        dut.wdata_i = value;
        dut.wstrb_i = 0xf;
        clock();
        dut.text_we_i = 0;
    }
    std::uint32_t read_text(std::uint32_t address) {
        dut.text_re_i = 1;
        dut.raddr_i = address & 0xfff;
        clock();
        dut.text_re_i = 0;
        return dut.rdata_o;
    }

    void poke(int which, int x, int y, std::uint16_t colour) {
        std::uint32_t& w = picture[which][y * 160 + x / 2];
        w = x % 2 ? (w & 0x0000ffff) | static_cast<std::uint32_t>(colour) << 16
                  : (w & 0xffff0000) | colour;
    }
};

TEST_F(Vga, KeepsTheStandardsTimingInEveryLineAndFrame) {
    shown();
    seen.clear();
    clock(3 * FRAME);
    std::vector<int> hs_falls, hs_widths, vs_falls, vs_widths;
    int hs_at = 0, vs_at = 0;
    for (int i = 1; i < static_cast<int>(seen.size()); ++i) {
        if (seen[i - 1].hs && !seen[i].hs) hs_falls.push_back(hs_at = i);
        if (!seen[i - 1].hs && seen[i].hs && hs_at) hs_widths.push_back(i - hs_at);
        if (seen[i - 1].vs && !seen[i].vs) vs_falls.push_back(vs_at = i);
        if (!seen[i - 1].vs && seen[i].vs && vs_at) vs_widths.push_back(i - vs_at);
    }
    for (std::size_t i = 1; i < hs_falls.size(); ++i) ASSERT_EQ(hs_falls[i] - hs_falls[i - 1], 800);
    for (const int width : hs_widths) ASSERT_EQ(width, 96);
    ASSERT_GE(vs_falls.size(), 2u);
    EXPECT_EQ(vs_falls[1] - vs_falls[0], 420'000);
    for (const int width : vs_widths) EXPECT_EQ(width, 1600);

    int first = vs_falls[0];
    while (!seen[first].blank_n) ++first;
    EXPECT_EQ(first - vs_falls[0], 35 * 800 + 96 + 48);  // 2 of sync and 33 of porch; HS and porch
    int end = first;
    while (seen[end].blank_n) ++end;
    EXPECT_EQ(end - first, 640);
    int next_hs = end;
    while (seen[next_hs].hs) ++next_hs;
    EXPECT_EQ(next_hs - end, 16);
}

TEST_F(Vga, ShowsEveryPixelTwoByTwo) {
    for (int y = 0; y < 240; ++y)
        for (int x = 0; x < 320; ++x) poke(0, x, y, static_cast<std::uint16_t>(x * 7 + y * 331));
    const auto pixels = shown();
    ASSERT_EQ(pixels.size(), 640u * 480);
    for (int y = 0; y < 480; ++y)
        for (int x = 0; x < 640; ++x) {
            const auto c = static_cast<std::uint16_t>((x / 2) * 7 + (y / 2) * 331);
            const unsigned r = c >> 11, g = c >> 5 & 63, b = c & 31;
            const std::uint32_t rgb =
                (r << 3 | r >> 2) << 16 | (g << 2 | g >> 4) << 8 | (b << 3 | b >> 2);
            ASSERT_EQ(pixels[y * 640 + x], rgb) << x << "," << y;
        }
}

TEST_F(Vga, IsBlackInTheBlanking) {
    for (auto& w : picture[0]) w = 0xffffffff;
    shown();
    for (const Pins& p : seen) ASSERT_TRUE(p.blank_n || p.rgb == 0u);
}

TEST_F(Vga, ReadsOneWordForFourClocks) {
    shown();
    fetches = 0;
    clock(FRAME);
    EXPECT_EQ(fetches, 480u * 160);
}

TEST_F(Vga, SwapsOnlyWhenTheFrameEnds) {
    for (auto& w : picture[0]) w = 0x11111111;
    for (auto& w : picture[1]) w = 0x22222222;
    write(PIXEL_BACK_BUFFER, PICTURE1_BASE);
    const std::uint32_t before = shown()[0];
    while (!dut.vga_blank_no) clock();
    clock(100 * LINE);
    write(PIXEL_BUFFER, 0);
    EXPECT_EQ(read(PIXEL_STATUS) & 1, 1u);
    EXPECT_EQ(read(PIXEL_BUFFER), 0xC8000000u);
    seen.clear();
    while (dut.vga_vs_no) clock();
    for (const Pins& p : seen) ASSERT_TRUE(!p.blank_n || p.rgb == before) << "torn";
    EXPECT_EQ(read(PIXEL_STATUS) & 1, 0u);
    EXPECT_EQ(read(PIXEL_BUFFER), 0xC0000000u);
    EXPECT_EQ(read(PIXEL_BACK_BUFFER), 0xC8000000u);
    const auto after = shown();
    for (const std::uint32_t rgb : after) ASSERT_NE(rgb, before);
}

TEST_F(Vga, SwapsBackAndForth) {
    write(PIXEL_BACK_BUFFER, PICTURE1_BASE);
    for (int i = 0; i < 3; ++i) {
        write(PIXEL_BUFFER, 1);
        clock(FRAME);
        EXPECT_EQ(read(PIXEL_BUFFER), i % 2 ? 0xC8000000u : 0xC0000000u);
    }
    clock(FRAME);
    EXPECT_EQ(read(PIXEL_BUFFER), 0xC0000000u) << "a swap that nobody asked for";
}

TEST_F(Vga, NeverLoadsTheBufferRegisterDirectly) {
    write(PIXEL_BUFFER, 0x12345678);
    EXPECT_EQ(read(PIXEL_BUFFER), 0xC8000000u);
    clock(FRAME);
    EXPECT_EQ(read(PIXEL_BUFFER), 0xC8000000u);  // both registers point at PICTURE0 after reset
}

TEST_F(Vga, HasTheDocumentedRegistersAfterReset) {
    EXPECT_EQ(read(0xFF203020), 0xC8000000u);
    EXPECT_EQ(read(0xFF203024), 0xC8000000u);
    EXPECT_EQ(read(0xFF203028), 0x00F00140u);
    EXPECT_EQ(read(0xFF20302C), 0x08090F04u);
}

TEST_F(Vga, KeepsItsResolutionWhateverIsWritten) {
    write(PIXEL_RESOLUTION, 0);
    EXPECT_EQ(read(PIXEL_RESOLUTION), 240u << 16 | 320u);
    EXPECT_EQ(read(PIXEL_STATUS) & 1, 0u) << "no swap was asked for";
}

TEST_F(Vga, WritesTheBackBufferByLanes) {
    write(PIXEL_BACK_BUFFER, 0x12345678);
    write(PIXEL_BACK_BUFFER, 0xaabbccdd, 0x5);
    EXPECT_EQ(read(PIXEL_BACK_BUFFER), 0x12bb56ddu);
}

TEST_F(Vga, GoesBlackWhileDisabledAndKeepsItsTiming) {
    for (auto& w : picture[0]) w = 0xffffffff;
    write(PIXEL_STATUS, 0);
    EXPECT_EQ(read(PIXEL_STATUS), 0x08090F00u);
    auto pixels = shown();
    ASSERT_EQ(pixels.size(), 640u * 480);
    for (const std::uint32_t rgb : pixels) ASSERT_EQ(rgb, 0u);
    write(PIXEL_STATUS, 4);
    EXPECT_EQ(shown()[0], 0xffffffu);
}

TEST_F(Vga, StartsAtTheRowThatTheBufferAddressNames) {
    for (int y = 0; y < 240; ++y) poke(1, 0, y, y == 200 ? 0xf800 : 0x07e0);
    write(PIXEL_BACK_BUFFER, PICTURE1_BASE + (200 << 10));
    write(PIXEL_BUFFER, 1);
    clock(FRAME);
    const auto pixels = shown();
    EXPECT_EQ(pixels[0], 0xff0000u);
    EXPECT_EQ(pixels[2 * 640], 0x00ff00u);
    for (int y = 2 * 40; y < 480; ++y) ASSERT_EQ(pixels[y * 640], 0u) << "row " << y;
}

TEST_F(Vga, ShowsBlackForAnAddressOutsideThePictures) {
    for (auto& p : picture)
        for (auto& w : p) w = 0xffffffff;
    write(PIXEL_BACK_BUFFER, 0xC4000000);
    write(PIXEL_BUFFER, 1);
    clock(FRAME);
    for (const std::uint32_t rgb : shown()) ASSERT_EQ(rgb, 0u);
}

TEST_F(Vga, AnswersTheResamplersStatus) {
    dut.resampler_re_i = 1;
    clock();
    dut.resampler_re_i = 0;
    EXPECT_EQ(dut.rdata_o, 0x14u);
    clock();
    EXPECT_EQ(dut.rdata_o, 0u);
}

TEST_F(Vga, ShowsLettersInWhiteOverThePixelsAndNothingForOtherCodes) {
    for (int y = 0; y < 240; ++y)
        for (int x = 0; x < 320; ++x) poke(0, x, y, static_cast<std::uint16_t>(x * 7 + y * 331));
    const auto bare = shown();
    for (unsigned i = 0; i < text.size(); ++i) text[i] = static_cast<std::uint8_t>(i * 5 % 128);
    const auto pixels = shown();
    unsigned strokes = 0;
    for (unsigned cell = 0; cell < text.size(); ++cell) {
        gfx::Canvas letter;
        if (text[cell] >= ' ' && text[cell] <= '~')
            gfx::text(letter, 1, 0, std::string(1, static_cast<char>(text[cell])), gfx::Colour{1});
        for (int y = 0; y < 8; ++y)
            for (int x = 0; x < 8; ++x) {
                const std::size_t at =
                    (cell / 80 * 8 + static_cast<unsigned>(y)) * 640 + cell % 80 * 8 + x;
                const bool stroke = letter.row(y)[x] != 0;
                strokes += stroke;
                ASSERT_EQ(pixels[at], stroke ? 0xffffffu : bare[at]) << cell << ": " << x << y;
            }
    }
    EXPECT_GT(strokes, 10'000u);
}

TEST_F(Vga, TakesCharactersModulo128) {
    text[0] = 'A';
    const auto pixels = shown();
    text[0] = 'A' | 0x80;
    EXPECT_EQ(shown(), pixels);
    text[0] = 0;
    EXPECT_NE(shown(), pixels);
}

TEST_F(Vga, ReadsOneCharacterForEightClocks) {
    shown();
    cell_fetches = 0;
    clock(FRAME);
    EXPECT_EQ(cell_fetches, 480u * 80);
}

TEST_F(Vga, ReadsAndShowsNoCharactersWhileThereAreOnlyBlanks) {
    for (auto& code : text) code = 'A';
    dut.cells_any_i = 0;
    shown();
    cell_fetches = 0;
    for (const std::uint32_t rgb : shown()) ASSERT_EQ(rgb, 0u);
    EXPECT_EQ(cell_fetches, 0u);
}

TEST_F(Vga, ShowsNoCharactersWhileTheyAreDisabled) {
    for (auto& code : text) code = 'A';
    write_text(TEXT_STATUS, 0);
    for (const std::uint32_t rgb : shown()) ASSERT_EQ(rgb, 0u);
}

TEST_F(Vga, HasTheDocumentedCharacterRegistersAfterReset) {
    EXPECT_EQ(read_text(0xFF203030), 0xC9000000u);
    EXPECT_EQ(read_text(0xFF203034), 0xC9000000u);
    EXPECT_EQ(read_text(0xFF203038), 0x003C0050u);
    EXPECT_EQ(read_text(0xFF20303C) & 7, 4u);
}

TEST_F(Vga, SwapsCharacterBuffersAtTheFramesEndApartFromThePictures) {
    write_text(TEXT_BACK_BUFFER, 0xC9000800);
    write_text(TEXT_BUFFER, 1);
    EXPECT_EQ(read_text(TEXT_STATUS) & 1, 1u);
    EXPECT_EQ(read(PIXEL_STATUS) & 1, 0u);
    clock(FRAME);
    EXPECT_EQ(read_text(TEXT_STATUS) & 1, 0u);
    EXPECT_EQ(read_text(TEXT_BUFFER), 0xC9000800u);
}

TEST_F(Vga, ClearsTheCharactersOnBit16OfBufferAlone) {
    write_text(TEXT_BUFFER, 1);
    clock();
    EXPECT_EQ(dut.clear_o, 0);
    write_text(TEXT_BACK_BUFFER, 1 << 16);
    EXPECT_EQ(dut.clear_o, 0);
    write_text(TEXT_BUFFER, 1 << 16);
    EXPECT_EQ(dut.clear_o, 1);
    dut.clearing_i = 1;
    clock();
    EXPECT_EQ(dut.clear_o, 0);
    EXPECT_EQ(read_text(TEXT_BUFFER) >> 16 & 1, 1u);
    EXPECT_EQ(read_text(TEXT_RESOLUTION), 0x003C0050u);
    dut.clearing_i = 0;
    EXPECT_EQ(read_text(TEXT_BUFFER) >> 16 & 1, 0u);
}

TEST_F(Vga, ClocksTheDacInTheMiddleOfAPixel) {
    dut.clk_i = 1;
    dut.eval();
    EXPECT_EQ(dut.vga_clk_o, 0);
    dut.clk_i = 0;
    dut.eval();
    EXPECT_EQ(dut.vga_clk_o, 1);
}

}  // namespace
