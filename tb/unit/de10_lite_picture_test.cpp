// The DE10-Lite Computer's picture: where its pixels go in the fabric's memory, and when.
#include <cstring>
#include <vector>

#include <gtest/gtest.h>

#include "sim/chip/de10_lite_picture.h"

namespace {

class De10LitePicture : public testing::Test {
protected:
    static constexpr std::uint32_t ONCHIP = 0x08000000, SDRAM = 0x00100000;
    static constexpr std::size_t RESET = 8, LINE = 800, FRAME = 525 * LINE, SHOWN = 480 * LINE;
    static constexpr std::size_t BATCH = 1024;

    void draw(std::uint32_t address, unsigned x, unsigned y, std::uint16_t colour) {
        const std::uint32_t offset = y << 9 | x << 1;
        std::uint8_t bytes[2];
        std::memcpy(bytes, &colour, sizeof bytes);
        if (address == ONCHIP)
            picture.write(offset, bytes, sizeof bytes);
        else
            std::memcpy(&sdram[address + offset], bytes, sizeof bytes);
    }
    // A pixel of the 320 x 240 that the fabric shows.
    std::uint16_t shown(unsigned x, unsigned y) const {
        std::uint16_t pixel;
        std::memcpy(&pixel, &fabric[y << 10 | x << 1], sizeof pixel);
        return pixel;
    }
    // In the fabric's batches.
    void beam(std::size_t clocks) {
        for (; clocks > BATCH; clocks -= BATCH) picture.beam(BATCH);
        picture.beam(clocks);
    }
    void swap_to(std::uint32_t address) {
        picture.set_back(address);
        picture.ask(0);
    }

    std::vector<std::uint8_t> sdram = std::vector<std::uint8_t>(64 << 20);
    std::vector<std::uint8_t> fabric = std::vector<std::uint8_t>(256 << 10);
    sim::De10LitePicture picture{
        sdram.data(), [this](std::uint32_t offset, const std::uint8_t* data, unsigned bytes) {
            std::memcpy(&fabric[offset], data, bytes);
        }};
};

TEST_F(De10LitePicture, MakesFourPixelsOfEach) {
    draw(ONCHIP, 159, 119, 0xABCD);
    EXPECT_EQ(shown(318, 238), 0xABCD);
    EXPECT_EQ(shown(319, 238), 0xABCD);
    EXPECT_EQ(shown(318, 239), 0xABCD);
    EXPECT_EQ(shown(319, 239), 0xABCD);
    EXPECT_EQ(shown(317, 238), 0);
}

TEST_F(De10LitePicture, KeepsEachByteOfItsMemory) {
    for (std::uint32_t at = 0; at < picture.MEMORY_SIZE; at += 3) {
        const auto byte = static_cast<std::uint8_t>(at * 7);
        picture.write(at, &byte, 1);
    }
    for (std::uint32_t at = 0; at < picture.MEMORY_SIZE; at += 3) {
        std::uint8_t byte;
        picture.read(at, &byte, 1);
        ASSERT_EQ(byte, static_cast<std::uint8_t>(at * 7)) << at;
    }
}

TEST_F(De10LitePicture, SwapsWhereTheFrameEnds) {
    swap_to(SDRAM);
    beam(RESET + SHOWN - 1);
    EXPECT_EQ(picture.front(), ONCHIP);
    beam(1);
    EXPECT_EQ(picture.front(), SDRAM);
    EXPECT_EQ(picture.back(), ONCHIP);
}

TEST_F(De10LitePicture, SwapsNotForARequestAfterTheFramesEnd) {
    picture.set_back(SDRAM);
    picture.ask(RESET + SHOWN + 1);
    beam(RESET + SHOWN + 100);
    EXPECT_EQ(picture.front(), ONCHIP);
    beam(FRAME);
    EXPECT_EQ(picture.front(), SDRAM);
}

TEST_F(De10LitePicture, SwapsNotWhileAControllerIsOff) {
    picture.enable(false);
    swap_to(SDRAM);
    beam(RESET + 2 * FRAME);
    EXPECT_EQ(picture.front(), ONCHIP);
}

TEST_F(De10LitePicture, SwapsWhereTheProgramHasSeenIt) {
    swap_to(SDRAM);
    picture.seen(true);
    EXPECT_EQ(picture.front(), ONCHIP);
    picture.seen(false);
    EXPECT_EQ(picture.front(), SDRAM);
}

TEST_F(De10LitePicture, ShowsTheSdramTwoRowsAheadOfTheBeam) {
    draw(SDRAM, 5, 0, 0x1111);
    draw(SDRAM, 5, 100, 0x2222);
    swap_to(SDRAM);
    beam(RESET + SHOWN);
    EXPECT_EQ(shown(10, 0), 0x1111);
    beam(FRAME - SHOWN + 98 * 4 * LINE - 1);
    EXPECT_EQ(shown(10, 200), 0);
    beam(1);
    EXPECT_EQ(shown(10, 200), 0x2222);
}

TEST_F(De10LitePicture, ShowsTheOnChipMemoryAgainAfterTheSdram) {
    draw(ONCHIP, 5, 60, 0x1234);
    draw(SDRAM, 5, 60, 0x5678);
    swap_to(SDRAM);
    beam(RESET + 2 * FRAME);
    EXPECT_EQ(shown(11, 121), 0x5678);
    draw(ONCHIP, 5, 60, 0x4321);
    EXPECT_EQ(shown(11, 121), 0x5678);
    picture.ask(RESET + 2 * FRAME);
    beam(FRAME);
    EXPECT_EQ(shown(11, 121), 0x4321);
}

}  // namespace
