// vga.v and pixel_dma.v: registers, swap and pixels; the test is the memories and looks at the
// ADV7123's pins.  Their timing is proved (tb/formal).
#include "regmap.h"
#include "tb/rtl/vga_bench.h"

namespace {

using namespace regmap;
using tb::FRAME;

using Vga = tb::VgaBench;

TEST_F(Vga, SwapsBackAndForth) {
    write(PIXEL_BACK_BUFFER, SDRAM_BASE);
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
    EXPECT_EQ(read(PIXEL_BUFFER), 0xC8000000u);  // both registers point at it after reset
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
    EXPECT_EQ(read(PIXEL_BACK_BUFFER), 0xd2bb56ddu);
    write(PIXEL_BUFFER, 1);
    write(PIXEL_BACK_BUFFER, 0xaabbccdd, 0xa);
    EXPECT_EQ(read(PIXEL_BACK_BUFFER), 0xeabbccddu) << "while a swap waits";
}

TEST_F(Vga, ReadsTheTwoHighestBitsOfBothAddressesAsOnes) {
    write(PIXEL_BACK_BUFFER, 0x00012340);
    EXPECT_EQ(read(PIXEL_BACK_BUFFER), 0xC0012340u);
    write(PIXEL_BUFFER, 1);
    clock(FRAME);
    EXPECT_EQ(read(PIXEL_BUFFER), 0xC0012340u);
}

TEST_F(Vga, DropsASwapInTheClockOfABackBufferWrite) {
    for (int i = 0; i < 2; ++i) {
        write(PIXEL_BACK_BUFFER, SDRAM_BASE);
        write(PIXEL_BUFFER, 1);
        while (read(PIXEL_STATUS) & 1) {
        }
        const std::uint64_t end = clocks;  // the clock after the one in which a frame ended
        write(PIXEL_BUFFER, 1);
        clock(static_cast<int>(FRAME - 2 - (clocks - end) - i));
        write(PIXEL_BACK_BUFFER, SDRAM_BASE + 0x1000);
        clock(5);
        EXPECT_EQ(read(PIXEL_STATUS) & 1, 0u);
        EXPECT_EQ(read(PIXEL_BUFFER), i ? 0xC0001000u : 0xC0000000u) << i;
        EXPECT_EQ(read(PIXEL_BACK_BUFFER), i ? 0xC0000000u : 0xC0001000u) << i;
        reset();
    }
}

TEST_F(Vga, SwapsNothingWhileEitherControllerIsDisabled) {
    for (const bool pixels : {true, false}) {
        pixels ? write(PIXEL_STATUS, 0) : write_text(TEXT_STATUS, 0);
        write(PIXEL_BUFFER, 1);
        write_text(TEXT_BUFFER, 1);
        clock(2 * FRAME);
        EXPECT_EQ(read(PIXEL_STATUS) & 1, 1u);
        EXPECT_EQ(read_text(TEXT_STATUS) & 1, 1u);
        pixels ? write(PIXEL_STATUS, 4) : write_text(TEXT_STATUS, 4);
        clock(FRAME);
        EXPECT_EQ(read(PIXEL_STATUS) & 1, 0u);
        EXPECT_EQ(read_text(TEXT_STATUS) & 1, 0u);
    }
}

TEST_F(Vga, StartsAtTheRowThatTheBufferAddressNames) {
    for (unsigned y = 0; y < 240; ++y) poke(sdram, 0u, y, y == 200 ? 0xf800 : 0x07e0);
    write(PIXEL_BACK_BUFFER, SDRAM_BASE + (200 << 10));
    write(PIXEL_BUFFER, 1);
    clock(FRAME);
    const auto pixels = shown();
    EXPECT_EQ(pixels[0], 0xff0000u);
    EXPECT_EQ(pixels[2 * 640], 0x00ff00u);
    for (int y = 2 * 40; y < 480; ++y) ASSERT_EQ(pixels[y * 640], 0u) << "row " << y;
}

std::uint32_t widened(unsigned c) {
    const unsigned r = c >> 11, g = c >> 5 & 63, b = c & 31;
    return (r << 3 | r >> 2) << 16 | (g << 2 | g >> 4) << 8 | (b << 3 | b >> 2);
}

// Random runs of a few colours, so that some blocks of 16 pixels equal the pixel before them.
TEST_F(Vga, ShowsAnyPictureFromAnyPlaceOfBothMemories) {
    for (auto* memory : {&onchip, &sdram}) {
        std::uint16_t colour = 0;
        for (std::uint32_t at = 0; at < 4 * memory->size(); at += 2) {
            if (random() % 24 == 0) colour = static_cast<std::uint16_t>(random());
            poke(*memory, at, colour);
        }
    }
    for (const std::uint32_t front :
         {0xC8000000, 0xC8000402, 0xC8001234, 0xC0000000, 0xC012357A, 0xC0FFFFFE, 0xC8039000,
          0xC803FF00, 0xC3FFF002, 0xC7FFF000, 0xC4000000, 0x00012340u, 0x18000000u, 0x7FFFF000u}) {
        SCOPED_TRACE(testing::Message() << std::hex << front);
        write(PIXEL_BACK_BUFFER, front);
        write(PIXEL_BUFFER, 1);
        clock(FRAME);
        const auto pixels = shown();
        ASSERT_EQ(pixels.size(), 640u * 480);
        for (std::uint32_t y = 0; y < 480; ++y)
            for (std::uint32_t x = 0; x < 640; ++x) {
                const auto in_onchip = [](std::uint32_t a) { return a >> 18 == 0x8000000 >> 18; };
                const std::uint32_t begins = (front + y / 2 * 1024) & 0xfffffff,
                                    at = (begins + x / 2 * 2) & 0xfffffff;
                const std::uint32_t shows = in_onchip(at)       ? onchip[(at - 0x08000000) / 4]
                                            : in_onchip(begins) ? 0
                                                                : sdram[at / 4 % SDRAM_WORDS];
                ASSERT_EQ(pixels[y * 640 + x], widened(at & 2 ? shows >> 16 : shows & 0xffff))
                    << x << "," << y;
            }
    }
}

TEST_F(Vga, AnswersTheResamplersStatus) {
    dut.resampler_re_i = 1;
    clock();
    dut.resampler_re_i = 0;
    EXPECT_EQ(dut.rdata_o, 0x00190014u);
    clock();
    EXPECT_EQ(dut.rdata_o, 0u);
}

}  // namespace
