// fabric_memory_test.cpp - fpga.v's memories through the bridge, its headers, the keypad's wires
#include <cstdint>
#include <vector>

#include "tb/rtl/fabric_bench.h"

namespace {

using namespace regmap;
using namespace tb;
using Bytes = std::vector<std::uint8_t>;

TEST_F(FabricPorts, ReachEveryBankAndBothEndsOfTheMemories) {
    std::vector<std::uint32_t> places{ONCHIP_BASE, ONCHIP_BASE + ONCHIP_SIZE - 4, SDRAM_BASE,
                                      CHARACTERS_BASE};
    for (std::uint32_t offset = 4; offset < SDRAM_SIZE; offset *= 2)
        places.push_back(SDRAM_BASE + offset);
    for (std::uint32_t offset = 4; offset < CHARACTERS_SIZE; offset *= 2)
        places.push_back(CHARACTERS_BASE + offset);
    fabric.run_clocks(10'000);  // while the SDRAM is initialised
    std::uint8_t number = 0;
    for (const std::uint32_t place : places) {
        ++number;
        put(place, {number, 1, 2, static_cast<std::uint8_t>(~number)});
    }
    number = 0;
    for (const std::uint32_t place : places) {
        ++number;
        EXPECT_EQ(bytes_at(place, 4), (Bytes{number, 1, 2, static_cast<std::uint8_t>(~number)}))
            << std::hex << place;
    }
    EXPECT_EQ(pins.memory.violations(), 0u);
}

// A row of the picture has 320 pixels of 512: the processor writes to the rest.
TEST_F(FabricPorts, KeepWhatIsWrittenWhileAPictureComesIn) {
    constexpr std::uint32_t ROW = 1024, PICTURE = 640, BURST = 64;
    write(VIDEO_IN_BACK_BUFFER, ONCHIP_BASE);
    write(VIDEO_IN_BUFFER, 1);
    write(VIDEO_IN_STATUS, VIDEO_IN_STATUS_EN_MASK);
    constexpr unsigned ROUNDS = 90;  // longer than a picture
    const auto written = [](unsigned round, std::uint32_t place) {
        Bytes bytes(BURST);
        for (std::uint32_t i = 0; i < BURST; ++i)
            bytes[i] = static_cast<std::uint8_t>(place / BURST * 7 + i + round / 6 * 29);
        return bytes;
    };
    for (unsigned round = 0; round < ROUNDS; ++round)
        for (std::uint32_t row = 0; row < 240; ++row) {
            const std::uint32_t place = ONCHIP_BASE + row * ROW + PICTURE + BURST * (round % 6);
            put(place, written(round, place));
        }
    for (std::uint32_t row = 0; row < 240; ++row) {
        EXPECT_EQ(bytes_at(ONCHIP_BASE + row * ROW + 320, 2), (Bytes{0xf5, 0x10})) << row;
        for (std::uint32_t burst = 0; burst < 6; ++burst) {
            const std::uint32_t place = ONCHIP_BASE + row * ROW + PICTURE + BURST * burst;
            ASSERT_EQ(bytes_at(place, BURST), written(ROUNDS - 1, place)) << row << ", " << burst;
        }
    }
}

// D31-D0 of JP1 and JP2, as the DE1-SoC Computer's manual has them.
unsigned pin_of(unsigned bit) {
    return bit == 0 ? 1 : bit <= 13 ? bit + 2 : bit == 14 ? 17 : bit + 4;
}

TEST_F(FabricPorts, DriveEachPinOfTheirHeaderAlone) {
    constexpr std::uint32_t data[] = {JP1_DATA, JP2_DATA}, direction[] = {JP1_DIR, JP2_DIR};
    for (const unsigned header : {0u, 1u}) {
        write(data[header], 0xffffffff);
        for (unsigned bit = 0; bit < 32; ++bit) {
            write(direction[header], 1u << bit);
            sim::HeaderMasks expected{};
            expected[header] = std::uint64_t{1} << pin_of(bit);
            EXPECT_EQ(pins.driven.enable, expected) << bit;
            EXPECT_EQ(pins.driven.levels[header] & expected[header], expected[header]) << bit;
        }
        write(direction[header], 0);
    }
}

// Columns on D7 (left) to D4, rows on D3 (top) to D0; a key joins its row and its column.
TEST_F(FabricPorts, SeeEachKeypadKeyInItsRowAndColumn) {
    unsigned row = 0, column = 0;
    pins.on_headers = [&](sim::ChipInputs& in) {
        const std::uint64_t column_pin = std::uint64_t{1} << pin_of(7 - column),
                            row_pin = std::uint64_t{1} << pin_of(3 - row);
        const bool low = pins.driven.enable[0] & ~pins.driven.levels[0] & column_pin;
        in.gpio[0] = sim::ALL_HEADER_PINS & ~(low ? row_pin | column_pin : 0);
    };
    write(KEYPAD_DEBOUNCE, 1);
    write(KEYPAD_CONTROL, 1);
    for (unsigned key = 0; key < 16; ++key) {
        row = key / 4;
        column = key % 4;
        fabric.run_clocks(4 * 4 * 1250);  // four scans
        EXPECT_EQ(read(KEYPAD_KEYS), 1u << key);
    }
}

}  // namespace
