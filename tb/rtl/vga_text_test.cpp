// vga.v: the characters over the pixels, and their controller.
#include <algorithm>
#include <string>

#include "gfx/font.h"
#include "regmap.h"
#include "tb/rtl/vga_bench.h"

namespace {

using namespace regmap;
using tb::FRAME;

using VgaText = tb::VgaBench;

TEST_F(VgaText, ShowsWhiteLettersOverThePixels) {
    for (unsigned y = 0; y < 240; ++y)
        for (unsigned x = 0; x < 320; ++x)
            poke(onchip, x, y, static_cast<std::uint16_t>(x * 7 + y * 331));
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

TEST_F(VgaText, TakesCharactersModulo128) {
    text[0] = 'A';
    const auto pixels = shown();
    text[0] = 'A' | 0x80;
    EXPECT_EQ(shown(), pixels);
    text[0] = 0;
    EXPECT_NE(shown(), pixels);
}

TEST_F(VgaText, ReadsOneCharacterForEightClocks) {
    shown();
    cell_fetches = 0;
    clock(FRAME);
    EXPECT_EQ(cell_fetches, 480u * 80);
}

TEST_F(VgaText, ReadsAndShowsNoCharactersWhileThereAreOnlyBlanks) {
    for (auto& code : text) code = 'A';
    dut.cells_any_i = 0;
    shown();
    cell_fetches = 0;
    for (const std::uint32_t rgb : shown()) ASSERT_EQ(rgb, 0u);
    EXPECT_EQ(cell_fetches, 0u);
}

TEST_F(VgaText, BeginsCharactersWithALine) {
    for (auto& code : text) code = '_';  // its only stroke is in the letter's last line but one
    const auto whole = shown();
    dut.cells_any_i = 0;
    shown();
    const auto line =
        static_cast<unsigned>(std::find(whole.begin(), whole.end(), 0xffffffu) - whole.begin()) /
        640;
    ASSERT_LT(line, 8u);
    clock(FRAME - 400);
    seen.clear();
    while (seen.size() < line * 640u + 320) clock();
    dut.cells_any_i = 1;
    while (seen.size() < (line + 8) * 640u + 640) clock();
    for (unsigned x = 0; x < 640; ++x) {
        ASSERT_EQ(seen[line * 640 + x], 0u) << x;
        ASSERT_EQ(seen[(line + 8) * 640 + x], whole[(line + 8) * 640 + x]) << x;
    }
}

TEST_F(VgaText, ShowsNeitherCharactersNorPixelsWhileEitherIsDisabled) {
    for (auto& w : onchip) w = 0xffffffff;
    for (auto& code : text) code = 'A';
    write_text(TEXT_STATUS, 0);
    for (const std::uint32_t rgb : shown()) ASSERT_EQ(rgb, 0u);
    write_text(TEXT_STATUS, 4);
    write(PIXEL_STATUS, 0);
    for (const std::uint32_t rgb : shown()) ASSERT_EQ(rgb, 0u);
}

TEST_F(VgaText, ShowsTheCharactersFromWhereTheirBufferBegins) {
    for (auto& code : text) code = ' ';
    text[80 + 3] = 'A';  // row 1, column 3
    const auto there = shown();
    for (const std::uint32_t begins : {0u, 2u, 128u, 131u, 8191u}) {
        write_text(TEXT_BACK_BUFFER, 0xC9000000 + begins);
        write_text(TEXT_BUFFER, 1);
        clock(FRAME);
        const unsigned cell = (128 + 3 + 8192 - begins) % 8192;  // row << 7 | column
        const auto pixels = shown();
        for (unsigned y = 0; y < 8; ++y)
            for (unsigned x = 0; x < 8; ++x)
                ASSERT_EQ(pixels[((cell >> 7) * 8 + y) * 640 + (cell & 127) * 8 + x],
                          there[(8 + y) * 640 + 3 * 8 + x])
                    << begins;
    }
}

TEST_F(VgaText, HasTheDocumentedCharacterRegistersAfterReset) {
    EXPECT_EQ(read_text(0xFF203030), 0xC9000000u);
    EXPECT_EQ(read_text(0xFF203034), 0xC9000000u);
    EXPECT_EQ(read_text(0xFF203038), 0x003C0050u);
    EXPECT_EQ(read_text(0xFF20303C), 0x06070704u);
}

TEST_F(VgaText, SwapsCharacterBuffersAtTheFramesEnd) {
    write_text(TEXT_BACK_BUFFER, 0xC9000800);
    write_text(TEXT_BUFFER, 1);
    EXPECT_EQ(read_text(TEXT_STATUS) & 1, 1u);
    EXPECT_EQ(read(PIXEL_STATUS) & 1, 0u);
    clock(FRAME);
    EXPECT_EQ(read_text(TEXT_STATUS) & 1, 0u);
    EXPECT_EQ(read_text(TEXT_BUFFER), 0xC9000800u);
}

TEST_F(VgaText, ClearsTheCharactersOnBit16OfBufferAlone) {
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

}  // namespace
