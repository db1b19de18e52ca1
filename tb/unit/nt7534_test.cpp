// nt7534_test.cpp - the commands of the NT7534, as its data sheet has them
#include "sim/board/nt7534.h"

#include <initializer_list>

#include <gtest/gtest.h>

#include "sim/board/hps_lcd.h"

namespace {

constexpr std::uint32_t BLACK = 0, GREY = 0x808080, WHITE = 0xFFFFFF;

struct Lcd {
    sim::Nt7534 chip;

    Lcd() { command({0xC8, 0x2F, 0x40, 0xAF}); }

    void command(std::initializer_list<int> bytes) {
        for (const int byte : bytes) chip.write(static_cast<std::uint8_t>(byte), false);
    }
    void data(std::initializer_list<int> bytes) {
        for (const int byte : bytes) chip.write(static_cast<std::uint8_t>(byte), true);
    }
    bool black(unsigned x, unsigned y) const {
        return chip.picture(true).pixels[y * sim::Nt7534::WIDTH + x] == BLACK;
    }
    unsigned count() const {
        unsigned all = 0;
        for (const std::uint32_t pixel : chip.picture(true).pixels) all += pixel == BLACK;
        return all;
    }
};

TEST(Nt7534, ShowsAByteAsEightDotsWithBitZeroAtTheTop) {
    Lcd lcd;
    lcd.command({0xB2, 0x13, 0x05});
    lcd.data({0x81, 0x02});
    EXPECT_TRUE(lcd.black(0x35, 16) && lcd.black(0x35, 23) && lcd.black(0x36, 17));
    EXPECT_EQ(lcd.count(), 3u);
}

TEST(Nt7534, TakesAColumnsHalvesInAnyOrder) {
    Lcd lcd;
    lcd.command({0x18, 0x02});  // column 130
    lcd.data({0, 0});
    lcd.command({0x0F, 0x10});  // after the last column: 15, the lower half first
    lcd.data({0x01});
    EXPECT_TRUE(lcd.black(15, 0));
    EXPECT_EQ(lcd.count(), 1u);
}

TEST(Nt7534, StopsAtItsLastColumn) {
    Lcd lcd;
    lcd.command({0xB0, 0x18, 0x02});  // column 130 of 0 to 131, not on the panel
    lcd.data({1, 2, 4, 8});
    EXPECT_EQ(lcd.count(), 0u);
    lcd.command({0xA1});  // from the right: columns 131 to 4
    EXPECT_TRUE(lcd.black(1, 0) && lcd.black(0, 3));
    EXPECT_EQ(lcd.count(), 2u);
}

TEST(Nt7534, ShowsNothingUntilItIsOnAndHasAllItsPower) {
    Lcd lcd;
    lcd.data({0xFF});
    EXPECT_EQ(lcd.count(), 8u);
    lcd.command({0x2E});
    EXPECT_EQ(lcd.count(), 0u);
    lcd.command({0x2F, 0xAE});
    EXPECT_EQ(lcd.count(), 0u);
    lcd.command({0xAF});
    EXPECT_EQ(lcd.count(), 8u);
}

TEST(Nt7534, InvertsFillsAndScrolls) {
    Lcd lcd;
    lcd.data({0x01});
    lcd.command({0xA7});
    EXPECT_EQ(lcd.count(), 128u * 64 - 1);
    lcd.command({0xA6, 0xA5});
    EXPECT_EQ(lcd.count(), 128u * 64);
    lcd.command({0xA4, 0x40 | 60});
    EXPECT_TRUE(lcd.black(0, 4));
    lcd.command({0xC0});  // lines from the bottom
    EXPECT_TRUE(lcd.black(0, 59));
}

TEST(Nt7534, TakesAByteAfterSomeCommands) {
    Lcd lcd;
    lcd.command({0x81, 0xAE, 0xAD, 0xA5});  // contrast and indicator, not "off" and "all dots"
    lcd.data({0x01});
    EXPECT_EQ(lcd.count(), 1u);
}

TEST(Nt7534, KeepsItsPowerWhenItBeginsAnew) {
    Lcd lcd;
    lcd.command({0xB7, 0x11});
    lcd.data({0x01});
    lcd.command({0xE2, 0xC8});
    lcd.data({0x01});
    EXPECT_TRUE(lcd.black(0, 0) && lcd.black(16, 56));
    EXPECT_EQ(lcd.count(), 2u);
}

TEST(HpsLcd, HasItsResetItsDataAndItsBacklightOnPins) {
    constexpr std::uint32_t BACKLIGHT = 1 << 8, DATA = 1 << 12, RUNS = 1 << 15;
    sim::HpsLcd lcd;
    lcd.gpio1(RUNS);
    for (const std::uint32_t byte : {0xC8u, 0x2Fu, 0xAFu}) lcd.spi0(byte);
    lcd.gpio1(RUNS | DATA);
    lcd.spi0(0x01);
    EXPECT_EQ(lcd.picture()->pixels[0], BLACK);
    EXPECT_EQ(lcd.picture()->pixels[1], GREY);
    lcd.gpio1(RUNS | BACKLIGHT);
    EXPECT_EQ(lcd.picture()->pixels[1], WHITE);
    lcd.gpio1(BACKLIGHT);
    EXPECT_EQ(lcd.picture()->pixels[0], WHITE) << "off after a reset";
}

}  // namespace
