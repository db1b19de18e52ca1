// keypad.v with its scanner: 16 switches without diodes are on the pins.  A slot is 8 clocks here.
#include <vector>

#include "Vkeypad.h"
#include "regmap.h"
#include "tb/support/register_bus.h"

namespace {

using namespace regmap;

constexpr int SCAN = 4 * 8;

class Keypad : public tb::RegisterBus<Vkeypad> {
protected:
    std::uint16_t held = 0;  // bit 4 * row + column
    unsigned scans = 4;      // debounce

    void SetUp() override {
        dut.row_ni = 0xf;
        reset();
        write(KEYPAD_CONTROL, 1);
        write(KEYPAD_DEBOUNCE, scans);
        clock(2 * SCAN);
    }

    // Wires that closed switches join are low if one of them is pulled low.
    void after_clock() override {
        unsigned cols = dut.col_low_o, rows = 0;
        for (int round = 0; round < 8; ++round)
            for (int key = 0; key < 16; ++key)
                if (held >> key & 1 && (cols >> key % 4 & 1 || rows >> key / 4 & 1)) {
                    cols |= 1u << key % 4;
                    rows |= 1u << key / 4;
                }
        dut.row_ni = ~rows & 0xf;
        EXPECT_EQ(dut.col_low_o & (dut.col_low_o - 1), 0) << "two columns low at once";
    }

    void hold(std::uint16_t keys) {
        held = keys;
        clock((scans + 2) * SCAN);
    }
    std::uint32_t take_event() {
        const std::uint32_t event = read(KEYPAD_EVENT);
        write(KEYPAD_EVENT, 0);
        return event;
    }
    static std::uint32_t event(int key, bool pressed) { return 0x8000 | pressed << 8 | key; }
};

TEST_F(Keypad, ReportsEachKeyAsItsOwnBitAndEvents) {
    for (int key = 0; key < 16; ++key) {
        hold(static_cast<std::uint16_t>(1u << key));
        EXPECT_EQ(read(KEYPAD_KEYS), 1u << key);
        EXPECT_EQ(take_event(), event(key, true));
        hold(0);
        EXPECT_EQ(read(KEYPAD_KEYS), 0u);
        EXPECT_EQ(take_event(), event(key, false));
        EXPECT_EQ(take_event(), 0u) << "key " << key << " reported twice";
    }
}

TEST_F(Keypad, IgnoresAPressShorterThanTheDebounceTime) {
    held = 1u << 6;
    clock((scans - 1) * SCAN);
    held = 0;
    clock(4 * scans * SCAN);
    EXPECT_EQ(read(KEYPAD_EVENT), 0u);
}

TEST_F(Keypad, ReportsAPressThatBouncesForLongOnce) {
    for (int bounce = 0; bounce < 40; ++bounce) {
        held = bounce % 2 ? 0 : 1u << 9;
        clock((scans - 1) * SCAN);
    }
    EXPECT_EQ(read(KEYPAD_EVENT), 0u);
    hold(1u << 9);
    EXPECT_EQ(take_event(), event(9, true));
    EXPECT_EQ(read(KEYPAD_EVENT), 0u);
}

TEST_F(Keypad, WaitsAsManyScansAsTheRegisterSays) {
    for (const unsigned time : {0u, 1u, 2u, 25u, 255u}) {
        write(KEYPAD_DEBOUNCE, time);
        held = 0x8000;
        unsigned waited = 0;
        while (read(KEYPAD_KEYS) == 0 && waited < 300 * SCAN) clock(), ++waited;
        const unsigned least = time == 0 ? 1 : time;
        EXPECT_GE(2 * waited, (least - 1) * SCAN) << time;
        EXPECT_LE(2 * waited, 2 * (least + 2) * SCAN) << time;
        held = 0;
        clock(600 * SCAN);
    }
}

TEST_F(Keypad, ShowsAChordAllAtOnce) {
    const std::uint16_t chord = 1u << 0 | 1u << 5 | 1u << 10;  // no two in a row or column
    held = chord;
    std::uint32_t keys = 0;
    for (int i = 0; i < 20 * SCAN && keys == 0; ++i) keys = read(KEYPAD_KEYS);
    EXPECT_EQ(keys, chord);
}

TEST_F(Keypad, InventsNoKeyWhenThreeCornersAreHeld) {
    hold(0x0011);  // rows 0 and 1 of column 0
    hold(0x0013);  // and row 0 of column 1: the fourth corner's path closes
    EXPECT_EQ(read(KEYPAD_KEYS), 0x0011u);
    EXPECT_EQ(read(KEYPAD_STATUS) & 0xc, 0xcu);
    hold(0x0012);  // two of them stay: unambiguous again
    EXPECT_EQ(read(KEYPAD_KEYS), 0x0012u);
    write(KEYPAD_STATUS, ~0x4u);
    EXPECT_EQ(read(KEYPAD_STATUS) & 0xc, 0x4u);
    write(KEYPAD_STATUS, 0x4);
    EXPECT_EQ(read(KEYPAD_STATUS) & 0xc, 0x0u);
}

TEST_F(Keypad, KeepsSixteenEventsInOrderAndReportsALostOne) {
    for (int i = 0; i < 8; ++i) {
        hold(static_cast<std::uint16_t>(1u << i));
        hold(0);
    }
    EXPECT_EQ(read(KEYPAD_STATUS) >> 8 & 31, 16u);
    EXPECT_EQ(read(KEYPAD_STATUS) & 2, 0u);
    hold(1u << 15);
    EXPECT_EQ(read(KEYPAD_STATUS) & 2, 2u);
    EXPECT_EQ(read(KEYPAD_KEYS), 1u << 15);
    write(KEYPAD_STATUS, ~2u);
    EXPECT_EQ(read(KEYPAD_STATUS) & 2, 2u);
    write(KEYPAD_STATUS, 2);
    EXPECT_EQ(read(KEYPAD_STATUS) & 2, 0u);
    for (int i = 0; i < 8; ++i) {
        EXPECT_EQ(take_event(), event(i, true));
        EXPECT_EQ(take_event(), event(i, false));
    }
    EXPECT_EQ(take_event(), 0u);
}

TEST_F(Keypad, ReportsTheEventsOfOneScanInKeyOrder) {
    write(KEYPAD_DEBOUNCE, scans = 2);  // a scan may see half of a chord
    const std::vector<std::vector<int>> chords{
        {0, 1}, {0, 15}, {0, 5, 10, 15}, {3, 6, 9, 12}, {0, 4, 12}, {12, 13, 14}, {7, 8}};
    for (const std::vector<int>& chord : chords)
        for (const bool pressed : {true, false}) {
            std::uint16_t keys = 0;
            for (const int key : chord) keys |= static_cast<std::uint16_t>(pressed << key);
            hold(keys);
            for (const int key : chord) EXPECT_EQ(take_event(), event(key, pressed)) << key;
            EXPECT_EQ(take_event(), 0u);
        }
    // A release and a press in one scan, the lower number first.
    hold(1u << 0 | 1u << 9);
    take_event();
    take_event();
    hold(1u << 2 | 1u << 9);
    EXPECT_EQ(take_event(), event(0, false));
    EXPECT_EQ(take_event(), event(2, true));
    hold(1u << 0 | 1u << 9);
    EXPECT_EQ(take_event(), event(0, true));
    EXPECT_EQ(take_event(), event(2, false));
}

TEST_F(Keypad, DropsAnEventOnlyByAWrite) {
    hold(1u << 3);
    read(KEYPAD_EVENT);
    write(KEYPAD_EVENT, 0xffffffff, 0x0);
    for (const std::uint32_t other : {KEYPAD_STATUS, KEYPAD_KEYS, KEYPAD_MASK, KEYPAD_MASK + 8})
        write(other, 0);
    EXPECT_EQ(read(KEYPAD_EVENT), event(3, true));
    for (const std::uint8_t strobes : {0x1, 0x2, 0x4, 0x8}) {
        hold(0);
        hold(1u << 3);
        EXPECT_EQ(read(KEYPAD_STATUS) >> 8 & 31, 3u);
        for (unsigned left = 3; left > 0; --left) {
            EXPECT_EQ(read(KEYPAD_STATUS) >> 8 & 31, left) << int{strobes};
            write(KEYPAD_EVENT, 0, strobes);
        }
        hold(0);
        write(KEYPAD_EVENT, 0);
        hold(1u << 3);
    }
}

TEST_F(Keypad, ChangesARegisterByItsByteLane) {
    write(KEYPAD_CONTROL, 0, 0xe);
    write(KEYPAD_DEBOUNCE, 0xffffffff, 0xe);
    write(KEYPAD_MASK, 0xffffffff, 0xe);
    EXPECT_EQ(read(KEYPAD_CONTROL), 1u);
    EXPECT_EQ(read(KEYPAD_DEBOUNCE), scans);
    EXPECT_EQ(read(KEYPAD_MASK), 0u);
    hold(0x0013);  // three corners
    write(KEYPAD_STATUS, 0xffffffff, 0xe);
    EXPECT_EQ(read(KEYPAD_STATUS) & 0xc, 0xcu);
    hold(0);
    write(KEYPAD_STATUS, 0x4, 0x1);
    EXPECT_EQ(read(KEYPAD_STATUS) & 0xc, 0u);
}

TEST_F(Keypad, InterruptsByMask) {
    hold(1);
    EXPECT_EQ(dut.irq_o, 0);
    write(KEYPAD_MASK, 1);
    EXPECT_EQ(dut.irq_o, 1);
    take_event();
    EXPECT_EQ(dut.irq_o, 0);
    write(KEYPAD_MASK, 4);
    hold(0x0013);
    EXPECT_EQ(dut.irq_o, 1);
    hold(0);
    write(KEYPAD_STATUS, 4);
    EXPECT_EQ(dut.irq_o, 0);
}

TEST_F(Keypad, LeavesThePinsAloneAndForgetsWhileDisabled) {
    hold(1);
    write(KEYPAD_CONTROL, 0);
    EXPECT_EQ(dut.enable_o, 0);
    hold(0x00f0);
    EXPECT_EQ(read(KEYPAD_KEYS), 0u);
    EXPECT_EQ(read(KEYPAD_STATUS) & 0x1f01, 0u);
    write(KEYPAD_CONTROL, 1);
    hold(2);
    EXPECT_EQ(take_event(), event(1, true));
}

TEST_F(Keypad, HasItsDocumentedDefaults) {
    reset();
    EXPECT_EQ(read(KEYPAD_CONTROL), 0u);
    EXPECT_EQ(read(KEYPAD_DEBOUNCE), 25u);  // of 0.2 ms: 5 ms
    EXPECT_EQ(read(KEYPAD_MASK), 0u);
    EXPECT_EQ(read(KEYPAD_EVENT), 0u);
}

TEST_F(Keypad, ReadsZeroAfterItsLastRegister) {
    write(KEYPAD_MASK, 7);
    write(KEYPAD_MASK + 4, 0xffffffff);
    EXPECT_EQ(read(KEYPAD_MASK + 4), 0u);
    EXPECT_EQ(read(KEYPAD_MASK + 8), 0u);
    EXPECT_EQ(read(KEYPAD_MASK), 7u);
}

}  // namespace
