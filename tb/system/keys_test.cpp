// keys_test.cpp - hands on the board, as the firmware sees them.
#include <gmock/gmock.h>

#include "regmap.h"
#include "tb/support/whole_board.h"

namespace {

using ::testing::ElementsAre;

class KeyOnTheBoard : public tb::WholeBoard {};

TEST_F(KeyOnTheBoard, OfTheProcessorIsReadAtItsOwnPort) {
    constexpr std::uint32_t PINS = 0xFF709050, HPS_KEY = 1u << 25;
    run_to_end([this](hal::Mmio& io, hal::Cpu& cpu) {
        EXPECT_NE(io.read(PINS) & HPS_KEY, 0u);
        board->hold(0, 1u << 4 | 1u << 0, 0);
        cpu.idle();
        EXPECT_EQ(io.read(PINS) & HPS_KEY, 0u);
        EXPECT_EQ(io.read(regmap::KEY_DATA), 0b0001u);
        board->release(0, 1u << 4, 0);
        cpu.idle();
        EXPECT_NE(io.read(PINS) & HPS_KEY, 0u);
        EXPECT_EQ(io.read(regmap::KEY_DATA), 0b0001u);
    });
}

class KeypadOnTheBoard : public tb::WholeBoard {};

TEST_F(KeypadOnTheBoard, CanBeScannedByHandOnJp1FromEitherSide) {
    run_to_end([this](hal::Mmio& io, hal::Cpu& cpu) {
        io.write(regmap::KEYPAD_CONTROL, 0);
        board->hold(1u << 6, 0, 0);  // row 1, column 2
        idle_ms(cpu, 6);

        // Drives the wires in `driven` high but for one at a time; which others are then low?
        const auto scan = [&](std::uint32_t driven) {
            io.write(regmap::JP1_DIR, driven);
            std::vector<std::uint32_t> low;
            for (std::uint32_t wire = 0x80; wire; wire >>= 1) {
                if (!(driven & wire)) continue;
                io.write(regmap::JP1_DATA, driven & ~wire);
                cpu.idle();
                low.push_back(~io.read(regmap::JP1_DATA) & ~driven & 0xff);
            }
            return low;
        };
        EXPECT_THAT(scan(0xf0), ElementsAre(0u, 0u, 0x04u, 0u));  // columns D7-D4, row 1 is D2
        EXPECT_THAT(scan(0x0f), ElementsAre(0u, 0x20u, 0u, 0u));  // rows D3-D0, column 2 is D5
    });
}

}  // namespace
