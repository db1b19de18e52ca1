// ili9341_test.cpp - the display controller, by its datasheet: commands, windows, colours, turns.
#include "sim/board/lt24.h"

#include <gmock/gmock.h>

namespace {

constexpr unsigned RED = 0xf800, GREEN = 0x07e0, BLUE = 0x001f;
constexpr unsigned MY = 0x80, MX = 0x40, MV = 0x20, BGR = 0x08;

class Ili9341 : public ::testing::Test {
protected:
    sim::Ili9341 chip;
    sim::Ili9341::Pins pins{true, true, true, true, true, 0};

    void word(bool rs, unsigned data) {
        pins.cs_n = false;
        pins.rs = rs;
        pins.data = static_cast<std::uint16_t>(data);
        pins.wr_n = false;
        chip.drive(pins);
        pins.wr_n = true;
        chip.drive(pins);
    }
    void send(unsigned command, const std::vector<unsigned>& parameters = {}) {
        word(false, command);
        for (const unsigned parameter : parameters) word(true, parameter);
    }
    // As the LT24's demonstrations do it: SS, BGR, 565.
    void begin(unsigned madctl = BGR) {
        pins.reset_n = false;
        chip.drive(pins);
        pins.reset_n = true;
        chip.drive(pins);
        send(0x36, {madctl});
        send(0x3A, {0x55});
        send(0xB6, {0x0A, 0xA2});
        send(0x11);
        send(0x29);
    }
    void window(unsigned left, unsigned right, unsigned top, unsigned bottom) {
        send(0x2A, {left >> 8, left & 0xff, right >> 8, right & 0xff});
        send(0x2B, {top >> 8, top & 0xff, bottom >> 8, bottom & 0xff});
    }
    std::uint32_t at(unsigned x, unsigned y) const {
        const sim::DisplayPicture picture = chip.picture();
        return picture.pixels[y * picture.width + x];
    }
    unsigned lit() const {
        unsigned count = 0;
        for (const std::uint32_t pixel : chip.picture().pixels) count += pixel != 0;
        return count;
    }
};

TEST_F(Ili9341, FillsAWindowAndBeginsAgain) {
    begin();
    window(10, 11, 20, 21);
    send(0x2C, {RED, GREEN, BLUE, 0xffff});
    EXPECT_EQ(chip.picture().width, 240u);
    EXPECT_EQ(at(10, 20), 0xff0000u);
    EXPECT_EQ(at(11, 20), 0x00ff00u);
    EXPECT_EQ(at(10, 21), 0x0000ffu);
    EXPECT_EQ(at(11, 21), 0xffffffu);
    EXPECT_EQ(lit(), 4u);
    word(true, BLUE);
    EXPECT_EQ(at(10, 20), 0x0000ffu) << "after the last comes the first";
    send(0x3C, {BLUE});
    EXPECT_EQ(at(11, 20), 0x0000ffu) << "RAMWRC goes on";
    send(0x2C, {RED});
    EXPECT_EQ(at(10, 20), 0xff0000u) << "RAMWR begins";
}

TEST_F(Ili9341, HasWindowsBeyond255) {
    begin();
    window(239, 239, 319, 319);
    send(0x2C, {GREEN});
    EXPECT_EQ(at(239, 319), 0x00ff00u);
    EXPECT_EQ(lit(), 1u);
}

TEST_F(Ili9341, TakesWordsAtTheRiseWhileSelected) {
    begin();
    window(0, 9, 0, 0);
    send(0x2C);
    pins = {true, true, true, false, true, RED};
    chip.drive(pins);
    pins.wr_n = true;
    chip.drive(pins);
    EXPECT_EQ(lit(), 0u);
    pins = {true, false, true, false, true, RED};
    chip.drive(pins);
    EXPECT_EQ(lit(), 0u);
    pins = {true, false, true, true, true, GREEN};  // together with the rise: too late
    chip.drive(pins);
    EXPECT_EQ(at(0, 0), 0xff0000u);
}

TEST_F(Ili9341, TakesTwoPixelsOf18BitsInThreeWords) {
    begin();
    send(0x3A, {0x66});
    window(0, 1, 0, 0);
    send(0x2C, {0xfc00, 0x00fc, 0x8000});
    EXPECT_EQ(at(0, 0), 0xff0000u);
    EXPECT_EQ(at(1, 0), 0xff8200u);
}

TEST_F(Ili9341, ExchangesRedAndBlueWithoutBgr) {
    begin(0);
    send(0x2C, {RED});
    EXPECT_EQ(at(0, 0), 0x0000ffu);
}

TEST_F(Ili9341, IsDarkAsleepOffAndWithoutBacklight) {
    begin();
    send(0x2C, {RED});
    for (const auto& [off, on] : {std::pair{0x28u, 0x29u}, {0x10u, 0x11u}}) {
        send(off);
        EXPECT_EQ(at(0, 0), 0u);
        send(on);
        EXPECT_EQ(at(0, 0), 0xff0000u);
    }
    pins.backlight = false;
    chip.drive(pins);
    EXPECT_EQ(at(0, 0), 0u);
    pins.backlight = true;
    send(0x21);
    EXPECT_EQ(at(0, 0), 0x00ffffu);
    send(0x01);
    EXPECT_EQ(at(0, 0), 0u) << "SWRESET puts it to sleep";
}

// The pixel that is written first, and the next one, for a person who holds it upright.
TEST_F(Ili9341, IsUprightAndMirroredAsMadctlSays) {
    const auto corner = [this](unsigned madctl) {
        chip = {};
        begin(madctl | BGR);
        window(0, madctl & MV ? 319 : 239, 0, madctl & MV ? 239 : 319);
        send(0x2C, {RED, GREEN});
        for (unsigned x : {0u, chip.picture().width - 1})
            if (at(x, 0) == 0xff0000) return x ? "right" : "left";
        return "elsewhere";
    };
    EXPECT_STREQ(corner(0), "left");
    EXPECT_EQ(at(1, 0), 0x00ff00u);
    EXPECT_STREQ(corner(MX), "right");
    EXPECT_STREQ(corner(MX | MY), "left");
    EXPECT_EQ(chip.picture().width, 240u);
    EXPECT_STREQ(corner(MV | MY), "left");
    EXPECT_EQ(chip.picture().width, 320u);
    EXPECT_EQ(chip.picture().height, 240u);
    EXPECT_EQ(at(1, 0), 0x00ff00u);
    EXPECT_STREQ(corner(MV | MX), "left");
    EXPECT_STREQ(corner(MV), "right");
    EXPECT_STREQ(corner(MV | MX | MY), "right");
}

TEST(Lt24, HasItsWiresWhereTerasicPutsThem) {
    EXPECT_THAT(sim::Lt24::pins(1),
                testing::ElementsAre(44, 43, 42, 41, 49, 50, 51, 52, 53, 54, 55, 56, 57, 58, 59, 60,
                                     46, 47, 48, 61, 69, 71));
    sim::Lt24 lt24{0};
    const std::uint64_t reset_n = std::uint64_t{1} << 33, on = std::uint64_t{1} << 35, rs = 1 << 12,
                        wr_n = 1 << 11;
    const auto word = [&](bool parameter, unsigned data) {
        std::uint64_t levels = reset_n | on | (parameter ? rs : 0);
        for (unsigned n = 0; n < 16; ++n)
            if (data >> n & 1) levels |= std::uint64_t{1} << sim::Lt24::pins(0)[n];
        lt24.look({levels, 0}, 0);
        lt24.look({levels | wr_n, 0}, 0);
    };
    for (const unsigned command : {0x11, 0x29}) word(false, command);
    word(false, 0x36);
    word(true, BGR);
    word(false, 0xB6);
    word(true, 0x0A);
    word(true, 0xA2);
    word(false, 0x3A);
    word(true, 0x55);
    word(false, 0x2C);
    word(true, 0xA53C);
    EXPECT_EQ(lt24.picture()->pixels[0], 0xa6a6e7u) << "6 bits of each colour";
}

}  // namespace
