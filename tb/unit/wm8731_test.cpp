// The WM8731 model alone: its registers and what they do, by the datasheet's tables.
#include <algorithm>
#include <string>

#include <gmock/gmock.h>

#include "tb/unit/wm8731_bench.h"

namespace {

using namespace tb;
using ::testing::ElementsAre;
using ::testing::EndsWith;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

using Wm8731Chip = Wm8731Bench;

// ---- Control ----

TEST_F(Wm8731Chip, ComesUpWithTheDatasheetsDefaults) {
    const unsigned defaults[] = {0x097, 0x097, 0x079, 0x079, 0x00a, 0x008, 0x09f, 0x00a, 0, 0};
    for (unsigned reg = 0; reg < 10; ++reg) EXPECT_EQ(chip.reg(reg), defaults[reg]) << "R" << reg;
}

TEST_F(Wm8731Chip, TakesNineBitsIntoEachRegister) {
    for (unsigned reg = 4; reg < 10; ++reg) {
        EXPECT_EQ(set(reg, 0x1a5 & ~MASTER), 3u);
        EXPECT_EQ(chip.reg(reg), 0x1a5 & ~MASTER) << "R" << reg;
    }
    EXPECT_EQ(chip.words(), 6u);
    EXPECT_EQ(chip.refused_words(), 0u);
    EXPECT_THAT(chip.errors(), IsEmpty());
}

TEST_F(Wm8731Chip, LoadsBothChannelsWhenAskedTo) {
    set(0, 0x105);
    EXPECT_EQ(chip.reg(1), 0x005);
    set(1, 0x013);
    EXPECT_EQ(chip.reg(0), 0x105);
    set(3, 0x160);
    EXPECT_EQ(chip.reg(2), 0x060);
}

TEST_F(Wm8731Chip, ForgetsEverythingWhenR15IsWrittenWithZero) {
    set_up(LEFT);
    EXPECT_EQ(set(15, 1), 3u);
    EXPECT_EQ(chip.reg(9), 1);
    EXPECT_EQ(set(15, 0), 3u);
    EXPECT_EQ(chip.reg(9), 0);
    EXPECT_EQ(chip.reg(7), 0x00a);
    EXPECT_EQ(chip.reg(6), 0x09f);
}

TEST_F(Wm8731Chip, AnswersToItsOwnAddressOnly) {
    for (unsigned address = 0; address < 256; address += 2)
        EXPECT_EQ(word(address, 9 << 1, 1), address == 0x34 ? 3u : 0u) << address;
    EXPECT_EQ(chip.words(), 1u);
    EXPECT_EQ(chip.refused_words(), 0u) << "words for others are not refused";
    EXPECT_THAT(chip.errors(), IsEmpty());
}

TEST_F(Wm8731Chip, DoesNotAnswerAMasterThatIsMuchTooFast) {
    quarter_ps = 40'000;  // five a bit: 5 MHz
    EXPECT_EQ(set(9, 1), 0u);
    EXPECT_EQ(set(9, 1), 0u);
    quarter_ps = 350'000;  // 571 kHz
    EXPECT_EQ(set(9, 1), 3u);
    quarter_ps = 400'000;  // 500 kHz
    EXPECT_EQ(set(9, 1), 3u);
    EXPECT_EQ(chip.refused_words(), 2u);
    EXPECT_THAT(chip.errors(),
                ElementsAre(HasSubstr("I2C: SCL at 5000 kHz, faster than the WM8731's 526 kHz"),
                            HasSubstr("it answers here, and may not on a board")));
}

TEST_F(Wm8731Chip, RefusesToBeRead) {
    EXPECT_EQ(word(0x35, 0, 0), 0u);
    EXPECT_EQ(chip.refused_words(), 1u);
    EXPECT_THAT(chip.errors(),
                ElementsAre(EndsWith(" s: I2C: a read, but the chip is write-only")));
}

TEST_F(Wm8731Chip, RefusesRegistersThatDoNotExist) {
    unsigned refused = 0;
    for (unsigned reg = 0; reg < 128; ++reg) {
        const bool exists = reg < 10 || reg == 15;
        EXPECT_EQ(set(reg, 0), exists ? 3u : 1u) << "R" << reg;
        refused += !exists;
    }
    EXPECT_EQ(chip.refused_words(), refused);
    EXPECT_EQ(chip.error_count(), refused);
    EXPECT_EQ(chip.errors().size(), 20u);
    EXPECT_THAT(chip.errors().front(), HasSubstr("register 10 does not exist"));
}

TEST_F(Wm8731Chip, RefusesAThirdByteOfData) {
    start();
    EXPECT_TRUE(byte(0x34) && byte(5 << 1) && byte(0x06));
    EXPECT_FALSE(byte(0x00));
    stop();
    EXPECT_EQ(chip.reg(5), 0x006);
    EXPECT_THAT(chip.errors(), ElementsAre(HasSubstr("more than two bytes")));
}

TEST_F(Wm8731Chip, IgnoresAWordThatIsCutShort) {
    start();
    byte(0x34), byte(5 << 1);
    stop();
    start();
    byte(0x34), byte(5 << 1);
    sda(true), scl(true), scl(false);
    sda(true), scl(true), scl(false);
    start();  // in the middle of the last byte
    EXPECT_EQ(chip.reg(5), 0x008);
    EXPECT_TRUE(byte(0x34) && byte(5 << 1) && byte(0x06)) << "a START begins again";
    stop();
    EXPECT_EQ(chip.reg(5), 0x006);
    EXPECT_THAT(chip.errors(), ElementsAre(HasSubstr("ends after 2 bytes and 0 bits"),
                                           HasSubstr("ends after 2 bytes and 2 bits")));
}

TEST_F(Wm8731Chip, RefusesTheWordThatATestChose) {
    chip.refuse_word(2);
    EXPECT_EQ(set(5, 6), 3u);
    EXPECT_EQ(set(5, 4), 0u);
    EXPECT_EQ(set(5, 2), 3u);
    EXPECT_EQ(chip.reg(5), 2);
    EXPECT_EQ(chip.refused_words(), 1u);
    EXPECT_THAT(chip.errors(), IsEmpty()) << "that is nobody's error";
}

TEST_F(Wm8731Chip, ReportsErrorsWithTheirTime) {
    now_ps = 1'234'567'890'000;
    set(10, 0);
    EXPECT_THAT(chip.errors(), ElementsAre(::testing::StartsWith("1.234")));
}

// ---- Sound ----

TEST_F(Wm8731Chip, TakesAnI2sSlotWithNoBclkToSpare) {
    set_up(I2S | BITS16);
    const std::string left = "1000000000000011", right = "0100000000000001";
    const auto frame = [&] {  // the last bit of a word comes after LRCK has moved
        slot(false, right.back() + left.substr(0, 15));
        slot(true, left.back() + right.substr(0, 15));
    };
    for (int i = 0; i < 5; ++i) frame();
    EXPECT_EQ(heard.back(), (Heard{0x80030000, 0x40010000}));
    line_in = {static_cast<std::int32_t>(0x80030000), 0x40010000};
    frame(), frame();
    adc_bits.clear();
    frame();
    EXPECT_EQ(adc_bits, right.back() + left.substr(0, 15) + left.back() + right.substr(0, 15));
    EXPECT_THAT(chip.errors(), IsEmpty());
}

TEST_F(Wm8731Chip, FindsTheWordInSlotsOf100Bclks) {
    const std::string left = binary(0x87654300, 24), right = binary(0x12345600, 24);
    const std::string ones(76, '1');
    set_up(RIGHT | BITS24);
    for (int i = 0; i < 4; ++i) slot(true, ones + left), slot(false, ones + right);
    EXPECT_EQ(heard.back(), (Heard{0x87654300, 0x12345600}));
    set_up(LEFT | BITS24);
    for (int i = 0; i < 4; ++i) slot(true, left + ones), slot(false, right + ones);
    EXPECT_EQ(heard.back(), (Heard{0x87654300, 0x12345600}));
}

TEST_F(Wm8731Chip, SwapsTheChannelsOnRequest) {
    set_up(LEFT | BITS16 | LRSWAP);
    for (int i = 0; i < 4; ++i) {
        slot(true, binary(0x11110000, 16));
        slot(false, binary(0x22220000, 16));
    }
    EXPECT_EQ(heard.back(), (Heard{0x22220000, 0x11110000}));
}

TEST_F(Wm8731Chip, PlaysZerosWhenAnyRegisterSaysSo) {
    const auto last = [this] {
        for (int i = 0; i < 4; ++i) {
            slot(true, binary(0x11110000, 16));
            slot(false, binary(0x22220000, 16));
        }
        return heard.back();
    };
    const Heard sound{0x11110000, 0x22220000}, silence{0, 0};
    struct {
        unsigned reg, value;
    } const quiet[] = {{9, 0}, {5, 0x008}, {6, 0x008}, {6, 0x010}, {6, 0x080}, {4, 0}, {15, 0}};
    for (const auto& q : quiet) {
        set_up(LEFT | BITS16);
        ASSERT_EQ(last(), sound);
        set(q.reg, q.value);
        EXPECT_EQ(last(), silence) << "R" << q.reg << " = " << q.value;
    }
}

TEST_F(Wm8731Chip, SendsTheMicrophoneOnBothSidesWhenR4SelectsIt) {
    line_in = {0x11110000, 0x22220000};
    microphone = {0x12340000, 0x43210000};
    const auto sent = [this] {
        for (int i = 0; i < 4; ++i) {
            adc_bits.clear();
            slot(true, std::string(16, '0'));
            slot(false, std::string(16, '0'));
        }
        return adc_bits;
    };
    const std::string voice = binary(0x12340000, 16), silence(32, '0');
    set_up(LEFT | BITS16);
    EXPECT_EQ(sent(), binary(0x11110000, 16) + binary(0x22220000, 16));
    set(4, 0x014);  // INSEL
    EXPECT_EQ(sent(), voice + voice);
    set(0, 0x097);  // LINE IN's mutes have no effect
    set(6, 0x001);  // nor has its power
    EXPECT_EQ(sent(), voice + voice);
    set(6, 0x002);  // MICPD
    EXPECT_EQ(sent(), silence);
    set(6, 0);
    set(4, 0x016);  // MUTEMIC
    EXPECT_EQ(sent(), silence);
}

TEST_F(Wm8731Chip, SendsZerosWhenAnyRegisterSaysSo) {
    line_in = {-1, -1};
    const auto ones = [this] {
        for (int i = 0; i < 4; ++i) {
            adc_bits.clear();
            slot(true, std::string(16, '0'));
            slot(false, std::string(16, '0'));
        }
        return std::count(adc_bits.begin(), adc_bits.end(), '1');
    };
    struct {
        unsigned reg, value;
        int ones;
    } const cases[] = {{9, 0, 0},    {6, 0x001, 0},  {6, 0x004, 0},  {6, 0x080, 0},
                       {4, 0x14, 0}, {0, 0x097, 16}, {1, 0x097, 16}, {5, 0x008, 32}};
    for (const auto& c : cases) {
        set_up(LEFT | BITS16);
        ASSERT_EQ(ones(), 32);
        set(c.reg, c.value);
        EXPECT_EQ(ones(), c.ones) << "R" << c.reg << " = " << c.value;
    }
}

TEST_F(Wm8731Chip, ReportsSlotsThatAreTooShortOnce) {
    set_up(I2S | BITS24);
    for (int i = 0; i < 10; ++i) {
        slot(false, std::string(32, '0'));
        slot(true, std::string(16, '0'));
    }
    EXPECT_THAT(chip.errors(),
                ElementsAre(HasSubstr("DACDAT: slots of 16 BCLKs for words of 24 bits")));
    EXPECT_GE(chip.error_count(), 7u);
}

TEST_F(Wm8731Chip, DoesNotMindBadSignalsWhileItIsNotActive) {
    for (int i = 0; i < 10; ++i) slot(i % 2, std::string(5, '0'));
    pins.bclk = false;
    drive(HALF_BCLK_PS);
    pins.bclk = pins.dacdat = true;  // together
    drive(HALF_BCLK_PS);
    EXPECT_THAT(chip.errors(), IsEmpty());
}

TEST_F(Wm8731Chip, ReportsDataThatMovesWithTheEdgeThatSamplesIt) {
    set_up(LEFT | BITS16);
    pins.bclk = false;
    drive(HALF_BCLK_PS);
    pins.bclk = true;
    pins.dacdat = true;
    drive(HALF_BCLK_PS);
    EXPECT_THAT(chip.errors(), ElementsAre(HasSubstr("moves within 10 ns")));
}

TEST_F(Wm8731Chip, ReportsDataThatMovesTooLateOrTooEarly) {
    set_up(LEFT | BITS16);
    const auto data_moves = [this](std::uint64_t wait_ps) {
        pins.dacdat = !pins.dacdat;
        drive(wait_ps);
    };
    const auto bclk_rises = [this](std::uint64_t wait_ps) {
        pins.bclk = true;
        drive(wait_ps);
    };
    const auto violates = [&](int offset_ps) {  // of the data, from the rising edge
        const std::uint64_t before = chip.error_count();
        pins.bclk = false;
        drive(HALF_BCLK_PS);
        if (offset_ps < 0)
            data_moves(HALF_BCLK_PS), bclk_rises(static_cast<std::uint64_t>(-offset_ps));
        else
            bclk_rises(HALF_BCLK_PS), data_moves(static_cast<std::uint64_t>(offset_ps));
        return chip.error_count() > before;
    };
    EXPECT_FALSE(violates(-10'000));
    EXPECT_TRUE(violates(-9'999));
    EXPECT_TRUE(violates(9'999));
    EXPECT_FALSE(violates(10'000));
}

TEST_F(Wm8731Chip, ReportsLrckThatMovesWhileBclkIsHigh) {
    set_up(I2S | BITS16);
    bclk(true, false);
    pins.daclrck = false;
    drive(HALF_BCLK_PS);
    EXPECT_THAT(chip.errors(), ElementsAre(HasSubstr("LRCK moves where BCLK does not fall")));
}

TEST_F(Wm8731Chip, MeasuresTheRateOfLrck) {
    EXPECT_EQ(chip.rate_hz(), 0.0);
    const auto frames = [this](unsigned bclks, int count) {
        while (count--) {
            slot(false, std::string(bclks / 2, '0'));
            slot(true, std::string(bclks - bclks / 2, '0'));
        }
    };
    frames(64, 4);
    EXPECT_DOUBLE_EQ(chip.rate_hz(), 3.125e6 / 64);
    frames(100, 1);
    frames(80, 2);
    EXPECT_DOUBLE_EQ(chip.rate_hz(), 3.125e6 / 64)
        << "one odd frame, and one of 80 so far, are no rate";
    frames(80, 2);
    EXPECT_DOUBLE_EQ(chip.rate_hz(), 3.125e6 / 80);
    for (int i = 0; i < 10; ++i) frames(200, 1), frames(201, 1);
    EXPECT_NEAR(chip.rate_hz(), 3.125e6 / 200.5, 50);
    const double rate = chip.rate_hz();
    for (int i = 0; i < 10; ++i) {
        frames(200 + i % 2, 1);
        EXPECT_EQ(chip.rate_hz(), rate) << "jitter below 1 % does not move it";
    }
}

}  // namespace
