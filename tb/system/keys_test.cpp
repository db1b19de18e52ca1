// keys_test.cpp - hands on the board, as the firmware sees them.
#include <gmock/gmock.h>

#include "regmap.h"
#include "tb/support/whole_board.h"

namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::UnorderedElementsAre;

constexpr std::uint16_t key(unsigned row, unsigned column) {
    return static_cast<std::uint16_t>(1u << (4 * row + column));
}

class KeyOnTheBoard : public tb::WholeBoard {};

TEST_F(KeyOnTheBoard, ReleaseIsCapturedAndInterruptsUntilItIsCleared) {
    run_to_end([this](hal::Mmio& io, hal::Cpu& cpu) {
        const auto interrupts = [&] {
            cpu.idle();
            board->chip().catch_up();
            return computer->fpga.fabric().irq();
        };
        io.write(regmap::KEY_MASK, 1u << 2);
        board->hold(0, 1u << 2 | 1u << 1, 0);
        cpu.idle();
        EXPECT_EQ(io.read(regmap::KEY_DATA), 0b0110u);
        EXPECT_EQ(io.read(regmap::KEY_EDGE), 0u);
        board->release(0, 1u << 1, 0);  // not in the mask
        EXPECT_EQ(interrupts(), 0u);
        board->release(0, 1u << 2, 0);
        EXPECT_EQ(interrupts(), 1u << (regmap::KEY_IRQ_ID - 72));
        EXPECT_EQ(io.read(regmap::KEY_DATA), 0u);
        EXPECT_EQ(io.read(regmap::KEY_EDGE), 0b0110u);
        io.write(regmap::KEY_EDGE, 1u << 2);
        EXPECT_EQ(io.read(regmap::KEY_EDGE), 0b0010u);
        EXPECT_EQ(interrupts(), 0u);
    });
}

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

class Ps2OnTheBoard : public tb::WholeBoard {
protected:
    static std::vector<std::uint32_t> received(hal::Mmio& io, std::uint32_t port) {
        std::vector<std::uint32_t> bytes;
        for (std::uint32_t data; (data = io.read(port)) & regmap::PS2_0_DATA_RVALID_MASK;)
            bytes.push_back(data & regmap::PS2_0_DATA_DATA_MASK);
        return bytes;
    }
};

TEST_F(Ps2OnTheBoard, HasKeyboardAndMouse) {
    run_to_end(
        [this](hal::Mmio& io, hal::Cpu& cpu) {
            idle_ms(cpu, 510);
            EXPECT_THAT(received(io, regmap::PS2_0_DATA), ElementsAre(0xAA));
            EXPECT_THAT(received(io, regmap::PS2_1_DATA), ElementsAre(0xAA, 0x00));
            io.write(regmap::PS2_1_DATA, 0xF4);
            io.write(regmap::PS2_1_CONTROL, regmap::PS2_1_CONTROL_RE_MASK);
            idle_ms(cpu, 5);
            EXPECT_THAT(received(io, regmap::PS2_1_DATA), ElementsAre(0xFA));
            board->ps2_mouse.move(-3, 4);
            board->ps2_keyboard.press(0x1C);
            idle_ms(cpu, 15);
            EXPECT_EQ(computer->fpga.fabric().irq(),
                      std::uint64_t{1} << (regmap::PS2_1_IRQ_ID - 72));
            EXPECT_THAT(received(io, regmap::PS2_1_DATA), ElementsAre(0x18, 0xFD, 0x04));
            EXPECT_THAT(received(io, regmap::PS2_0_DATA), ElementsAre(0x1C));
        },
        600);
}

class KeypadOnTheBoard : public tb::WholeBoard {
protected:
    static constexpr unsigned SETTLED_MS = 12;  // 5 ms of bounce, 5 ms of debouncing

    // Takes all events: the numbers of keys pressed, and -1 - number for those released.
    static std::vector<int> events(hal::Mmio& io) {
        std::vector<int> taken;
        for (;;) {
            const std::uint32_t event = io.read(regmap::KEYPAD_EVENT);
            if (!(event & regmap::KEYPAD_EVENT_VALID_MASK)) return taken;
            const int number = static_cast<int>(event & regmap::KEYPAD_EVENT_KEY_MASK);
            taken.push_back(event & regmap::KEYPAD_EVENT_PRESSED_MASK ? number : -1 - number);
            io.write(regmap::KEYPAD_EVENT, 0);
        }
    }
};

TEST_F(KeypadOnTheBoard, ReportsEveryKeyOfAChordOnce) {
    run_to_end([this](hal::Mmio& io, hal::Cpu& cpu) {
        io.write(regmap::KEYPAD_CONTROL, regmap::KEYPAD_CONTROL_EN_MASK);
        const std::uint16_t chord = key(0, 1) | key(2, 1) | key(3, 3);
        board->hold(chord, 0, 0);
        idle_ms(cpu, SETTLED_MS);
        EXPECT_EQ(io.read(regmap::KEYPAD_KEYS), chord);
        EXPECT_THAT(events(io), UnorderedElementsAre(1, 9, 15));
        board->release(chord, 0, 0);
        idle_ms(cpu, SETTLED_MS);
        EXPECT_THAT(events(io), UnorderedElementsAre(-1 - 1, -1 - 9, -1 - 15));
        EXPECT_EQ(io.read(regmap::KEYPAD_STATUS) & regmap::KEYPAD_STATUS_GHOST_MASK, 0u);
    });
}

TEST_F(KeypadOnTheBoard, FlagsThreeCornersOfARectangleAndInventsNoKey) {
    run_to_end([this](hal::Mmio& io, hal::Cpu& cpu) {
        constexpr std::uint32_t GHOST = regmap::KEYPAD_STATUS_GHOST_MASK,
                                HELD = regmap::KEYPAD_STATUS_GHOST_HELD_MASK;
        const auto ghost = [&] { return io.read(regmap::KEYPAD_STATUS) & (GHOST | HELD); };
        io.write(regmap::KEYPAD_CONTROL, regmap::KEYPAD_CONTROL_EN_MASK);
        board->hold(key(0, 0) | key(0, 1), 0, 0);
        idle_ms(cpu, SETTLED_MS);
        EXPECT_THAT(events(io), UnorderedElementsAre(0, 1));
        EXPECT_EQ(ghost(), 0u);

        board->hold(key(1, 0), 0, 0);  // the wires now close (1, 1) too
        idle_ms(cpu, SETTLED_MS);
        EXPECT_EQ(ghost(), GHOST | HELD);
        EXPECT_EQ(io.read(regmap::KEYPAD_KEYS), key(0, 0) | key(0, 1));
        EXPECT_THAT(events(io), IsEmpty());

        board->release(key(0, 0), 0, 0);  // and now it is clear what is held
        idle_ms(cpu, SETTLED_MS);
        EXPECT_EQ(ghost(), GHOST);
        EXPECT_EQ(io.read(regmap::KEYPAD_KEYS), key(0, 1) | key(1, 0));
        EXPECT_THAT(events(io), UnorderedElementsAre(-1 - 0, 4));
        io.write(regmap::KEYPAD_STATUS, GHOST);
        EXPECT_EQ(ghost(), 0u);
    });
}

TEST_F(KeypadOnTheBoard, CanBeScannedByHandOnJp1FromEitherSide) {
    run_to_end([this](hal::Mmio& io, hal::Cpu& cpu) {
        io.write(regmap::KEYPAD_CONTROL, 0);
        board->hold(key(1, 2), 0, 0);
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
