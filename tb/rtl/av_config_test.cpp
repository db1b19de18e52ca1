// av_config_test.cpp - the audio/video configuration's registers, and their effect on the codec
#include "tb/rtl/audio_bench.h"

namespace {

using namespace regmap;
using namespace tb;

constexpr std::uint32_t ACK = 1, RDY = 2, AIS = 1 << 8, CFG = 3 << 16;
constexpr int LEFT_HEADPHONE = 2, DIGITAL_PATH = 5;

class AvConfig : public Audio {
protected:
    unsigned addressed = 0;  // the byte after the last start condition

    void after_clock() override {
        Audio::after_clock();
        const bool scl = dut.i2c_sclk_o != 0;
        if (scl && scl_was_ && sda_was_ && !sda()) bits_ = 0;
        if (scl && !scl_was_ && bits_ < 8) {
            addressed = (addressed << 1 | sda()) & 0xff;
            ++bits_;
        }
        scl_was_ = scl;
        sda_was_ = sda();
    }
    void wait_until_ready() {
        for (int i = 0; i < 20'000 && !(read(AV_CONFIG_STATUS) & RDY); ++i) clock(10);
        EXPECT_TRUE(read(AV_CONFIG_STATUS) & RDY) << "never ready";
    }
    void send(std::uint32_t codec_register, std::uint32_t value) {
        write(AV_CONFIG_ADDRESS, codec_register);
        write(AV_CONFIG_DATA, value);
    }

private:
    bool scl_was_ = true, sda_was_ = true;
    unsigned bits_ = 8;
};

TEST_F(AvConfig, ReportsThatTheCodecIsSetUp) {
    EXPECT_EQ(read(0xFF203004), CFG | RDY | AIS);
    EXPECT_EQ(read(0xFF203000), 0u);
}

TEST_F(AvConfig, SendsNineBitsToTheRegisterAddressed) {
    send(LEFT_HEADPHONE, 0x0f0);
    EXPECT_EQ(read(AV_CONFIG_STATUS), CFG | AIS);
    wait_until_ready();
    EXPECT_EQ(codec.reg(LEFT_HEADPHONE), 0x0f0);
    send(LEFT_HEADPHONE, 0x155);
    wait_until_ready();
    EXPECT_EQ(codec.reg(LEFT_HEADPHONE), 0x155);
    EXPECT_EQ(read(AV_CONFIG_ADDRESS), 2u);
    EXPECT_EQ(read(AV_CONFIG_DATA), 0x155u);
    EXPECT_EQ(read(AV_CONFIG_STATUS), CFG | RDY | AIS);
}

TEST_F(AvConfig, ChangesAWordByItsByteLanes) {
    send(LEFT_HEADPHONE, 0x155);
    const std::pair<std::uint8_t, std::uint32_t> steps[] = {
        {0x1, 0x1aa}, {0xc, 0x1aa}, {0x2, 0x0aa}};
    for (const auto& [strobes, expected] : steps) {
        wait_until_ready();
        write(AV_CONFIG_DATA, 0x0aa, strobes);
        wait_until_ready();
        EXPECT_EQ(read(AV_CONFIG_DATA), expected);
        EXPECT_EQ(codec.reg(LEFT_HEADPHONE), expected);
    }
}

TEST_F(AvConfig, SendsOneWordForOneWrite) {
    const std::uint64_t words = codec.words();
    send(LEFT_HEADPHONE, 0x0f0);
    wait_until_ready();
    clock(50'000);
    EXPECT_EQ(codec.words(), words + 1);
}

TEST_F(AvConfig, MakesAWordWaitWhileAnotherIsUnderWay) {
    const std::uint64_t words = codec.words();
    send(LEFT_HEADPHONE, 0x0f0);
    send(DIGITAL_PATH, 0x008);
    EXPECT_EQ(codec.words(), words + 1) << "the bus has waited";
    wait_until_ready();
    EXPECT_EQ(codec.words(), words + 2);
    EXPECT_EQ(codec.reg(LEFT_HEADPHONE), 0x0f0);
    EXPECT_EQ(codec.reg(DIGITAL_PATH), 0x008);
}

TEST_F(AvConfig, TakesAnAddressWhileAWordIsUnderWay) {
    send(LEFT_HEADPHONE, 0x0f0);
    const std::uint64_t before = clocks;
    write(AV_CONFIG_ADDRESS, DIGITAL_PATH);
    EXPECT_LE(clocks - before, 2u);
    wait_until_ready();
    EXPECT_EQ(codec.reg(LEFT_HEADPHONE), 0x0f0);
    EXPECT_EQ(codec.reg(DIGITAL_PATH), 0);
}

TEST_F(AvConfig, KeepsTheDeviceAndTheInterruptsMask) {
    write(AV_CONFIG_CONTROL, 0xfffffffe);
    EXPECT_EQ(read(AV_CONFIG_CONTROL), 0x00030006u);
    write(AV_CONFIG_CONTROL, 0, 0x4);
    EXPECT_EQ(read(AV_CONFIG_CONTROL), 0x00000006u);
}

TEST_F(AvConfig, SendsNothingToTheCodecWhereAnotherDeviceIsNamed) {
    constexpr unsigned ADDRESSES[] = {0x1a, 0x20, 0x21, 0x21};
    for (const std::uint32_t device : {1u, 2u, 3u}) {
        write(AV_CONFIG_CONTROL, device << 16);
        send(LEFT_HEADPHONE << 1, 0x0f0);
        wait_until_ready();
        EXPECT_EQ(addressed, ADDRESSES[device] << 1) << device;
        EXPECT_EQ(read(AV_CONFIG_STATUS), CFG | RDY | AIS | ACK) << "the codec alone is there";
    }
    EXPECT_EQ(codec.reg(LEFT_HEADPHONE), 0x079);
}

TEST_F(AvConfig, ClearsItsRegistersWithTheCodec) {
    EXPECT_EQ(read(AV_CONFIG_DATA), 0x055u);
    write(AV_CONFIG_CONTROL, 0x00030006);
    write(AV_CONFIG_ADDRESS, 0xff);
    EXPECT_EQ(read(AV_CONFIG_ADDRESS), 0xffu);
    write(AV_CONFIG_CONTROL, 1);
    clock(2);
    EXPECT_EQ(read(AV_CONFIG_CONTROL), 0u);
    EXPECT_EQ(read(AV_CONFIG_ADDRESS), 0u);
    EXPECT_EQ(read(AV_CONFIG_DATA), 0x055u);
}

TEST_F(AvConfig, ShowsAWordThatWasNotAcknowledgedUntilTheNext) {
    codec.refuse_word(codec.words() + 1);
    send(LEFT_HEADPHONE, 0x0f0);
    wait_until_ready();
    EXPECT_EQ(read(AV_CONFIG_STATUS), CFG | RDY | AIS | ACK);
    send(LEFT_HEADPHONE, 0x0f0);
    EXPECT_EQ(read(AV_CONFIG_STATUS) & ACK, 0u);
    wait_until_ready();
    EXPECT_EQ(read(AV_CONFIG_STATUS), CFG | RDY | AIS);
}

TEST_F(AvConfig, SetsTheCodecUpAgain) {
    send(LEFT_HEADPHONE, 0x0f0);
    wait_until_ready();
    write(AV_CONFIG_CONTROL, 1);
    clock(2);
    EXPECT_EQ(read(AV_CONFIG_STATUS), CFG);
    wait_until_ready();
    EXPECT_EQ(read(AV_CONFIG_STATUS), CFG | RDY | AIS);
    EXPECT_EQ(codec.reg(LEFT_HEADPHONE), 0x079);
}

TEST_F(AvConfig, FinishesAWordBeforeANewSetUp) {
    const std::uint64_t words = codec.words();
    send(LEFT_HEADPHONE, 0x0f0);
    clock(1000);
    write(AV_CONFIG_CONTROL, 1);
    clock(2);
    wait_until_ready();
    EXPECT_EQ(read(AV_CONFIG_STATUS), CFG | RDY | AIS);
    EXPECT_EQ(codec.words(), words + 12);
    EXPECT_EQ(codec.reg(LEFT_HEADPHONE), 0x079);
}

TEST_F(AvConfig, ShowsASetUpThatFailed) {
    codec.refuse_word(codec.words() + 3);
    write(AV_CONFIG_CONTROL, 1);
    clock(2);
    wait_until_ready();
    EXPECT_EQ(read(AV_CONFIG_STATUS), CFG | RDY | ACK);
}

}  // namespace
