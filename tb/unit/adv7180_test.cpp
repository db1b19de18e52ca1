// adv7180_test.cpp - the video decoder's bytes against ITU-R BT.656 and BT.601.
#include <gmock/gmock.h>

#include <map>

#include "sim/board/adv7180.h"

namespace {

using sim::Adv7180;
using sim::Image;

constexpr std::uint64_t LINE = 1716, FRAME = 525 * LINE;

// XY of F, V, H by the standard's table of protection bits.
const std::map<int, std::array<bool, 3>> CODES{
    {0x80, {0, 0, 0}}, {0x9D, {0, 0, 1}}, {0xAB, {0, 1, 0}}, {0xB6, {0, 1, 1}},
    {0xC7, {1, 0, 0}}, {0xDA, {1, 0, 1}}, {0xEC, {1, 1, 0}}, {0xF1, {1, 1, 1}}};

class DecoderChip : public ::testing::Test {
protected:
    std::vector<std::string> said;
    Adv7180 chip{[this](const std::string& line) { said.push_back(line); }};

    void show(unsigned width, unsigned height, std::vector<std::uint8_t> rgb) {
        chip.show(std::make_shared<Image>(Image{width, height, std::move(rgb)}));
    }
    // Byte n of the pixels of a line, counted from 1.
    int pixel_byte(unsigned line, unsigned n) { return chip.data((line - 1) * LINE + 276 + n); }
};

// A master of the I2C bus, which hears the chip's pull.
class DecoderRegisters : public DecoderChip {
protected:
    std::uint64_t third_ps = 3'000'000;  // of a bit: 111 kHz

    void start() { wires(false, true), wires(true, true), wires(true, false), wires(false, false); }
    void stop() { wires(false, false), wires(true, false), wires(true, true); }
    bool bit(bool level) {
        wires(false, level);
        wires(true, level);
        const bool seen = level && !chip.pulls_sda_low();
        wires(false, level);
        return seen;
    }
    bool send(unsigned byte) {  // acknowledged
        for (int n = 7; n >= 0; --n) bit(byte >> n & 1);
        return !bit(true);
    }
    unsigned receive(bool more) {
        unsigned byte = 0;
        for (int n = 0; n < 8; ++n) byte = byte << 1 | (bit(true) ? 1u : 0u);
        bit(!more);
        return byte;
    }
    void write(unsigned subaddress, std::vector<unsigned> values) {
        start();
        EXPECT_TRUE(send(0x40) && send(subaddress));
        for (const unsigned value : values) EXPECT_TRUE(send(value));
        stop();
    }
    std::vector<unsigned> read(unsigned subaddress, unsigned count = 1) {
        start();
        EXPECT_TRUE(send(0x40) && send(subaddress));
        start();
        EXPECT_TRUE(send(0x41));
        std::vector<unsigned> values;
        while (values.size() < count) values.push_back(receive(values.size() + 1 < count));
        stop();
        return values;
    }

private:
    std::uint64_t now_ps = 0;

    void wires(bool scl, bool sda) {
        chip.drive_i2c(scl, sda && !chip.pulls_sda_low(), now_ps += third_ps);
    }
};

using ::testing::ElementsAre;

TEST_F(DecoderRegisters, AnswerAtTheirAddressAlone) {
    start();
    EXPECT_FALSE(send(0x42));
    stop();
    start();
    EXPECT_FALSE(send(0x34));
    stop();
    EXPECT_THAT(read(0x11), ElementsAre(0x1Eu));
}

TEST_F(DecoderRegisters, AnswerNoMasterThatIsMuchTooFast) {
    third_ps = 700'000;  // 476 kHz
    start();
    EXPECT_TRUE(send(0x40) && send(0x01));
    stop();
    third_ps = 20'000;
    for (int n = 0; n < 2; ++n) {
        start();
        EXPECT_FALSE(send(0x40));
        stop();
    }
    EXPECT_THAT(said, ::testing::ElementsAre(
                          ::testing::HasSubstr("476 kHz, faster than the ADV7180's 400 kHz"),
                          ::testing::HasSubstr("it does not answer")));
}

TEST_F(DecoderRegisters, AreReadBackAndCountUp) {
    EXPECT_THAT(read(0x01, 4), ElementsAre(0xC8u, 0u, 0x0Cu, 0x45u));
    write(0x08, {0x12, 0x34, 0x56});
    EXPECT_THAT(read(0x08, 3), ElementsAre(0x12u, 0x34u, 0x56u));
    write(0x0F, {0x80});
    EXPECT_THAT(read(0x08, 2), ElementsAre(0x80u, 0u));
}

TEST_F(DecoderRegisters, HaveAnotherMapFrom0x40On) {
    write(0x0E, {0x20});
    write(0x4D, {0x5A});
    EXPECT_THAT(read(0x4D), ElementsAre(0x5Au));
    write(0x0E, {0});
    EXPECT_THAT(read(0x4D), ElementsAre(0xEFu));
}

TEST_F(DecoderRegisters, ShowWhetherThereIsASignal) {
    EXPECT_THAT(read(0x10), ElementsAre(0x02u));
    EXPECT_THAT(read(0x13), ElementsAre(0x10u));
    show(1, 1, {9, 9, 9});
    EXPECT_THAT(read(0x10), ElementsAre(0x07u)) << "it was lost before";
    EXPECT_THAT(read(0x10, 4), ElementsAre(0x05u, 0x1Eu, 0u, 0x61u));
    write(0x10, {0xFF});
    EXPECT_THAT(read(0x10), ElementsAre(0x05u));
}

TEST_F(DecoderRegisters, ChooseTheColourOfAFreeRun) {
    write(0x0C, {0x46, 0x9B});
    EXPECT_EQ(pixel_byte(30, 0), 0xB0);
    EXPECT_EQ(pixel_byte(30, 1), 0x44);
    EXPECT_EQ(pixel_byte(30, 2), 0x90);
}

// Found as by a receiver without any state.
TEST_F(DecoderChip, BeginsAndEndsEachLineWithTheRightCode) {
    std::vector<std::uint64_t> begins;
    for (std::uint64_t n = 0; n < 2 * FRAME; ++n) {
        if (chip.data(n) != 0xFF) continue;
        ASSERT_EQ(chip.data(n + 1), 0);
        ASSERT_EQ(chip.data(n + 2), 0);
        const auto code = CODES.find(chip.data(n + 3));
        ASSERT_NE(code, CODES.end()) << n;
        if (code->second[2])
            begins.push_back(n);
        else
            ASSERT_EQ(n, begins.back() + 272) << "4 bytes of the code, 268 of blanking";
        const auto line = begins.size() - 1;  // counted from 0
        const unsigned number = line % 525 + 1;
        ASSERT_EQ(code->second[0], number < 4 || number > 265) << number;
        ASSERT_EQ(code->second[1], number < 10 || (number > 263 && number < 273)) << number;
        n += 3;
    }
    ASSERT_EQ(begins.size(), 1050u);
    for (std::size_t i = 0; i < begins.size(); ++i) ASSERT_EQ(begins[i], i * LINE);
}

TEST_F(DecoderChip, HasTheCodesBytesNowhereElse) {
    std::vector<std::uint8_t> rgb(3 * 720 * 480);
    for (std::size_t i = 0; i < rgb.size(); ++i) rgb[i] = static_cast<std::uint8_t>(i * i >> 3);
    show(720, 480, rgb);
    for (unsigned line = 0; line < 525; ++line)
        for (unsigned n = 0; n < LINE; ++n) {
            if (n < 4 || (n >= 272 && n < 276)) continue;
            const int byte = chip.data(line * LINE + n);
            ASSERT_TRUE(byte >= 1 && byte <= 254) << line + 1 << ":" << n;
            const int blank = n % 2 ? 0x10 : 0x80;
            ASSERT_TRUE(n >= 272 || byte == blank) << line + 1 << ":" << n;
        }
}

// The table that BT.601 and its companions give for bars of 75 %: Y, Cb, Cr.
TEST_F(DecoderChip, ShowsColourBarsWithTheStandardsLevels) {
    const int levels[8][3] = {{180, 128, 128}, {162, 44, 142}, {131, 156, 44}, {112, 72, 58},
                              {84, 184, 198},  {65, 100, 212}, {35, 212, 114}, {16, 128, 128}};
    std::vector<std::uint8_t> rgb;
    for (const int bar : {7, 6, 3, 2, 5, 4, 1, 0})
        for (const int bit : {4, 2, 1}) rgb.push_back(bar & bit ? 191 : 0);
    show(8, 1, rgb);
    for (const unsigned line : {22u, 261u, 285u, 524u})
        for (unsigned x = 0; x < 720; x += 2) {
            const int* want = levels[x / 90];
            const unsigned at = 2 * x;
            if ((x + 1) / 90 != x / 90) continue;
            ASSERT_NEAR(pixel_byte(line, at + 1), want[0], 1) << x;
            ASSERT_NEAR(pixel_byte(line, at + 3), want[0], 1) << x;
            ASSERT_NEAR(pixel_byte(line, at), want[1], 1) << x;
            ASSERT_NEAR(pixel_byte(line, at + 2), want[2], 1) << x;
        }
}

// A line of the second field lies under the one of the first that is 263 before it.
TEST_F(DecoderChip, ShowsEvenRowsFirstAndOddRowsSecond) {
    std::vector<std::uint8_t> rgb;
    for (int row = 0; row < 480; ++row) rgb.insert(rgb.end(), 3, row % 4 == 1 ? 255 : row / 4);
    show(1, 480, rgb);
    for (int row = 0; row < 480; ++row) {
        const unsigned line = row % 2 ? 285 + row / 2 : 22 + row / 2;
        const double level = row % 4 == 1 ? 1 : row / 4 / 255.0;
        ASSERT_NEAR(pixel_byte(line, 1), 16 + 219 * level, 0.51) << row;
    }
    for (const unsigned line : {10u, 21u, 262u, 263u, 273u, 284u, 525u})
        ASSERT_EQ(pixel_byte(line, 1), 16) << line;
}

TEST_F(DecoderChip, RunsFreelyInBlueWithoutACamera) {
    for (unsigned n = 0; n < 1440; n += 4) {
        ASSERT_EQ(pixel_byte(100, n), 0xC0);
        ASSERT_EQ(pixel_byte(100, n + 1), 0x34);
        ASSERT_EQ(pixel_byte(100, n + 2), 0x70);
    }
}

TEST_F(DecoderChip, SeesANewPictureFromTheNextLineOn) {
    show(1, 1, {255, 255, 255});
    EXPECT_EQ(pixel_byte(30, 1), 235);
    show(1, 1, {0, 0, 0});
    EXPECT_EQ(pixel_byte(30, 3), 235);
    EXPECT_EQ(pixel_byte(31, 1), 16);
}

}  // namespace
