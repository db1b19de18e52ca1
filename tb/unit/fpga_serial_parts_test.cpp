// Parts on the FPGA's serial wires on other boards: the ADXL345 by SPI and I2C, the ADV7513 by I2C.
#include <string>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "sim/board/adv7513.h"
#include "sim/board/adxl345_wires.h"

namespace {

using sim::Adv7513;
using sim::Adxl345Wires;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

constexpr std::uint64_t STEP_PS = 2'500'000;  // of a bit at 100 kHz

// A master on wires that `drive(scl, sda)` moves and `pulled()` looks at.
template <class Drive, class Pulled>
class ShortI2c {
public:
    ShortI2c(Drive drive, Pulled pulled) : drive_{drive}, pulled_{pulled} {}

    void start() {
        drive_(true, true);
        drive_(true, false);
        drive_(false, false);
    }
    void stop() {
        drive_(false, false);
        drive_(true, false);
        drive_(true, true);
    }
    bool write(std::uint8_t byte) {  // acknowledged
        for (int bit = 7; bit >= 0; --bit) clock(byte >> bit & 1);
        return !clock(true);
    }
    std::uint8_t read(bool more) {
        unsigned byte = 0;
        for (int bit = 0; bit < 8; ++bit) byte = byte << 1 | clock(true);
        clock(!more);
        return static_cast<std::uint8_t>(byte);
    }

private:
    bool clock(bool sda) {
        drive_(false, sda && !pulled_());
        drive_(true, sda && !pulled_());
        const bool level = sda && !pulled_();
        drive_(false, sda && !pulled_());
        return level;
    }
    Drive drive_;
    Pulled pulled_;
};

class AccelerometerWires : public ::testing::Test {
protected:
    void spi(bool cs_n, bool sclk, bool sdi, bool sdo = true) {
        wires.drive({cs_n, sclk, sdi && !wires.pulls_sdi_low(), sdo}, now_ps += STEP_PS);
    }
    // A transfer of these bytes, and what came back on SDO, or on SDI of three wires.
    std::vector<std::uint8_t> transfer(const std::vector<std::uint8_t>& bytes, bool three = false) {
        std::vector<std::uint8_t> answer;
        spi(false, true, true);
        for (const std::uint8_t byte : bytes) {
            unsigned taken = 0;
            for (int bit = 7; bit >= 0; --bit) {
                spi(false, false, byte >> bit & 1);
                taken = taken << 1 | !(three ? wires.pulls_sdi_low() : wires.pulls_sdo_low());
                spi(false, true, byte >> bit & 1);
            }
            answer.push_back(static_cast<std::uint8_t>(taken));
        }
        spi(true, true, true);
        return answer;
    }

    sim::Adxl345 chip;
    Adxl345Wires wires{chip};
    std::uint64_t now_ps = 0;
};

// Data sheet: DEVID at 0x00 is 0xE5, BW_RATE at 0x2C begins with 0x0A.
TEST_F(AccelerometerWires, AnswersSpiOfFourWires) {
    EXPECT_EQ(transfer({0x80, 0xFF})[1], 0xE5);
    EXPECT_EQ(transfer({0xAC, 0xFF})[1], 0x0A);
}

TEST_F(AccelerometerWires, TakesWhatSpiWrites) {
    transfer({0x6C, 0x0B, 0x08});  // BW_RATE and POWER_CTL
    EXPECT_THAT(transfer({0xEC, 0xFF, 0xFF}), ElementsAre(0xFF, 0x0B, 0x08));
}

TEST_F(AccelerometerWires, AnswersOnSdiOfThreeWires) {
    transfer({0x31, 0x40});
    EXPECT_EQ(transfer({0x80, 0xFF}, true)[1], 0xE5);
}

// Data sheet: with SDO high the address is 0x1D, else 0x53.
TEST_F(AccelerometerWires, AnswersI2cAtTheAddressThatSdoChooses) {
    for (const bool sdo : {false, true}) {
        ShortI2c master{[&](bool scl, bool sda) { spi(true, scl, sda, sdo); },
                        [&] { return wires.pulls_sdi_low(); }};
        master.start();
        EXPECT_EQ(master.write(0x53 << 1), !sdo);
        master.stop();
        const unsigned address = sdo ? 0x1D : 0x53;
        master.start();
        EXPECT_TRUE(master.write(static_cast<std::uint8_t>(address << 1)));
        EXPECT_TRUE(master.write(0x00));
        master.start();
        EXPECT_TRUE(master.write(static_cast<std::uint8_t>(address << 1 | 1)));
        EXPECT_EQ(master.read(false), 0xE5);
        master.stop();
    }
}

class HdmiTransmitter : public ::testing::Test {
protected:
    void move(bool scl, bool sda) {
        chip.drive_i2c(scl, sda && !chip.pulls_sda_low(), now_ps += STEP_PS);
    }
    void write(std::uint8_t number, std::uint8_t value) {
        ShortI2c master{[&](bool scl, bool sda) { move(scl, sda); },
                        [&] { return chip.pulls_sda_low(); }};
        master.start();
        for (const std::uint8_t byte : {std::uint8_t{0x72}, number, value})
            EXPECT_TRUE(master.write(byte));
        master.stop();
    }
    // A slot of 32 SCLKs of 64 x 48 kHz, MSB first; `late`: the MSB is at the second.
    void slot(bool lrclk, std::uint32_t bits, bool late) {
        constexpr std::uint64_t HALF_PS = 162'760;
        for (unsigned n = 0; n < 32; ++n) {
            const unsigned place = late ? n - 1 : n;
            const bool data = place < 32 && bits >> (31 - place) & 1;
            chip.drive_sound(false, lrclk, data, now_ps += HALF_PS);
            chip.drive_sound(true, lrclk, data, now_ps += HALF_PS);
        }
    }
    void frames(unsigned count, bool late, bool left_high) {
        for (unsigned n = 0; n < count; ++n) {
            slot(left_high, 0x12345600, late);
            slot(!left_high, 0xABCDEF00, late);
        }
    }
    // Programming Guide: 4.4.1, audio input; 0xAF, HDMI; N = 6144 for 48 kHz.
    void set_up_sound() {
        write(0x41, 0x10);
        write(0xAF, 0x06);
        write(0x02, 0x18);
    }
    std::vector<std::pair<std::uint32_t, std::uint32_t>> heard;
    std::vector<std::string> said;
    Adv7513 chip{
        [&](const std::string& line) { said.push_back(line); },
        [&](const sim::StereoSample& sample) { heard.emplace_back(sample.left, sample.right); }};
    std::uint64_t now_ps = 0;
};

// Programming Guide: 0x72, register 0x41, 0x10 for power up.
TEST_F(HdmiTransmitter, IsPoweredUpByItsRegister) {
    ShortI2c master{[&](bool scl, bool sda) { move(scl, sda); },
                    [&] { return chip.pulls_sda_low(); }};
    EXPECT_FALSE(chip.is_powered());
    master.start();
    EXPECT_FALSE(master.write(0x34));  // the DE1-SoC's codec
    master.stop();
    master.start();
    EXPECT_TRUE(master.write(0x72));
    EXPECT_TRUE(master.write(0x41));
    EXPECT_TRUE(master.write(0x10));
    master.stop();
    EXPECT_TRUE(chip.is_powered());
}

TEST_F(HdmiTransmitter, ReadsWhatWasWrittenAndThatAMonitorIsThere) {
    ShortI2c master{[&](bool scl, bool sda) { move(scl, sda); },
                    [&] { return chip.pulls_sda_low(); }};
    master.start();
    master.write(0x72);
    master.write(0x41);
    master.write(0x10);
    master.write(0x00);  // of 0x42, which cannot be written
    master.start();
    master.write(0x72);
    master.write(0x41);
    master.start();
    EXPECT_TRUE(master.write(0x73));
    EXPECT_EQ(master.read(true), 0x10);
    EXPECT_EQ(master.read(false) & 0x60, 0x60);
    master.stop();
}

// Programming Guide, 0x0C: 0 is I2S, 1 right-justified by 0x0D, 2 left-justified.
TEST_F(HdmiTransmitter, SendsTheSoundOfI2sInEachFormat) {
    const std::pair<std::uint32_t, std::uint32_t> sample{0x12345600, 0xABCDEF00};
    set_up_sound();
    frames(5, true, false);
    EXPECT_EQ(heard.back(), sample);
    EXPECT_NEAR(chip.rate_hz(), 48'000, 10);
    write(0x0C, 0xBE);
    frames(5, false, true);
    EXPECT_EQ(heard.back(), sample);
    write(0x0C, 0xBD);
    write(0x0D, 16);
    frames(5, false, true);
    EXPECT_EQ(heard.back(), std::make_pair(0x56000000u, 0xEF000000u));
    EXPECT_EQ(chip.silence(), "");
    EXPECT_TRUE(said.empty());
}

TEST_F(HdmiTransmitter, SaysWhyItIsSilent) {
    const auto why = [&] {
        frames(3, true, false);
        EXPECT_EQ(heard.back(), std::make_pair(0u, 0u));
        return chip.silence();
    };
    EXPECT_EQ(chip.silence(), "");
    EXPECT_THAT(why(), HasSubstr("it is powered down"));
    write(0x41, 0x10);
    EXPECT_THAT(why(), HasSubstr("DVI has no sound: expected HDMI (bit 1 of 0xAF)"));
    write(0xAF, 0x06);
    EXPECT_THAT(why(), HasSubstr("N is 0 (0x01 to 0x03): expected 6144 at 48 kHz"));
    write(0x02, 0x18);
    write(0x44, 0x19);
    EXPECT_THAT(why(), HasSubstr("it sends no sound or no N"));
    write(0x44, 0x79);
    write(0x0C, 0xB8);
    EXPECT_THAT(why(), HasSubstr("its input I2S0 is off"));
}

TEST_F(HdmiTransmitter, SaysThatNDoesNotFitTheRate) {
    set_up_sound();
    write(0x02, 0x01);
    frames(5, true, false);
    ASSERT_EQ(said.size(), 1u);
    EXPECT_THAT(said[0], HasSubstr("N is 256 (0x01 to 0x03): HDMI has 4096 to 20480 at 48000 Hz"));
}

}  // namespace
