// The HPS's I2C controllers, at their registers, with a device on the first one's bus.
#include <gmock/gmock.h>

#include "tb/sim/hps_bench.h"

namespace {

using ::testing::ElementsAre;

constexpr std::uint32_t READS = 0x100, STOP = 0x200, START_AGAIN = 0x400;

// Remembers what it is sent, answers 0x10, 0x11, ...; at address 0x53.
struct Device : sim::I2cDevices {
    std::vector<std::string> heard;
    std::uint8_t next = 0x10;
    bool takes = true;
    std::uint64_t scl_ps = 0;

    bool begin(std::uint8_t address, bool reads, std::uint64_t period, std::uint64_t) override {
        scl_ps = period;
        heard.push_back(reads ? "read" : "write");
        return address == 0x53;
    }
    bool write(std::uint8_t byte, std::uint64_t) override {
        heard.push_back(std::to_string(byte));
        return takes;
    }
    std::uint8_t read(std::uint64_t) override {
        heard.push_back("byte");
        return next++;
    }
    void end(std::uint64_t) override { heard.push_back("stop"); }
};

class I2cController : public tb::HpsBench {
protected:
    static constexpr std::uint32_t I2C = 0xFFC04000, CON = I2C, TAR = I2C + 4, DATA = I2C + 0x10,
                                   RAW = I2C + 0x34, MASK = I2C + 0x30, RX_TL = I2C + 0x38,
                                   EN = I2C + 0x6C, STAT = I2C + 0x70, TXFLR = I2C + 0x74,
                                   RXFLR = I2C + 0x78, ABORT = I2C + 0x80, EN_STAT = I2C + 0x9C;
    static constexpr std::uint32_t RX_UNDER = 1, RX_OVER = 2, RX_FULL = 4, TX_OVER = 8,
                                   TX_EMPTY = 0x10, TX_ABRT = 0x40, STOP_DET = 0x200;
    Device device;

    // 400 kHz as good as exactly: 250 clocks of 100 MHz a bit.
    void SetUp() override {
        HpsBench::SetUp();
        board.hps.i2c0.connect(&device);
        write(CON, 0x65);
        write(TAR, 0x53);
        write(I2C + 0x1C, 90 - 9);
        write(I2C + 0x20, 160 - 1);
        write(EN, 1);
    }
    void wait_bits(double bits) { wait_ns(bits * 2500 + 20); }
};

TEST_F(I2cController, HasTheValuesOfAReset) {
    constexpr std::uint32_t I2C1 = 0xFFC05000;
    EXPECT_EQ(read(I2C1), 0x7Du);
    EXPECT_EQ(read(I2C1 + 4), 0x1055u);
    EXPECT_EQ(read(I2C1 + 0x30), 0x8FFu);
    EXPECT_EQ(read(I2C1 + 0x70), 6u);
    EXPECT_EQ(read(I2C1 + 0xF4), 0x3F3FEAu);
    EXPECT_EQ(read(I2C1 + 0xFC), 0x44570140u);
}

TEST_F(I2cController, ReadsARegisterOfADevice) {
    write(DATA, START_AGAIN | 0x32);
    write(DATA, READS);
    write(DATA, READS | STOP);
    wait_bits(10 + 9 + 10 + 9);
    EXPECT_EQ(read(RXFLR), 1u);
    wait_bits(10);
    EXPECT_EQ(read(RXFLR), 2u);
    EXPECT_EQ(device.scl_ps, 2'500'000u);
    EXPECT_EQ(read(DATA), 0x10u);
    EXPECT_EQ(read(DATA), 0x11u);
    EXPECT_THAT(device.heard, ElementsAre("write", "50", "read", "byte", "byte", "stop"));
    EXPECT_EQ(read(RAW) & STOP_DET, STOP_DET);
}

TEST_F(I2cController, TakesNineClocksOfSclForAByte) {
    write(DATA, 1);
    wait_bits(19 - 0.1);
    EXPECT_THAT(device.heard, ElementsAre("write"));
    wait_bits(0.2);
    EXPECT_THAT(device.heard, ElementsAre("write", "1"));
}

TEST_F(I2cController, HoldsTheBusUntilAStop) {
    write(DATA, 1);
    wait_bits(100);
    EXPECT_EQ(read(STAT) & 0x21, 0x21u);
    write(DATA, 2 | STOP);
    wait_bits(11);
    EXPECT_EQ(read(STAT) & 0x21, 0u);
    EXPECT_THAT(device.heard, ElementsAre("write", "1", "2", "stop"));
}

TEST_F(I2cController, AbortsWhereNobodyAnswersUntilTheProgramHasSeenIt) {
    write(EN, 0);
    write(TAR, 0x1A);
    write(EN, 1);
    write(DATA, 1);
    write(DATA, 2 | STOP);
    wait_bits(100);
    EXPECT_EQ(read(RAW) & TX_ABRT, TX_ABRT);
    EXPECT_EQ(read(ABORT), 1u);
    EXPECT_EQ(read(TXFLR), 0u);
    write(DATA, 3);
    EXPECT_EQ(read(TXFLR), 0u) << "what comes is dropped";
    read(I2C + 0x54);
    EXPECT_EQ(read(RAW) & TX_ABRT, 0u);
    EXPECT_EQ(read(ABORT), 0u);
    write(DATA, 3);
    EXPECT_EQ(read(TXFLR), 1u);
}

TEST_F(I2cController, AbortsWhereAByteIsNotTaken) {
    device.takes = false;
    write(DATA, 1);
    wait_bits(20);
    EXPECT_EQ(read(ABORT), 8u);
    EXPECT_THAT(device.heard, ElementsAre("write", "1", "stop"));
}

TEST_F(I2cController, HasFifosOf64) {
    for (int i = 0; i < 66; ++i) write(DATA, READS);
    EXPECT_EQ(read(TXFLR), 64u);
    EXPECT_EQ(read(STAT) & 2, 0u) << "full";
    EXPECT_EQ(read(RAW) & TX_OVER, TX_OVER);
    wait_bits(10 + 64 * 9 + 1);
    write(DATA, READS);
    wait_bits(10);
    EXPECT_EQ(read(RXFLR), 64u);
    EXPECT_EQ(read(RAW) & RX_OVER, RX_OVER);
    for (unsigned i = 0; i < 64; ++i) ASSERT_EQ(read(DATA), 0x10 + i);
    EXPECT_EQ(read(RAW) & RX_UNDER, 0u);
    read(DATA);
    EXPECT_EQ(read(RAW) & RX_UNDER, RX_UNDER);
}

TEST_F(I2cController, InterruptsAsItsMaskSays) {
    take(190);
    write(MASK, RX_FULL);
    write(RX_TL, 1);
    write(DATA, READS);
    write(DATA, READS | STOP);
    wait_bits(10 + 9);
    EXPECT_FALSE(board.irq);
    wait_bits(10);
    EXPECT_TRUE(board.irq);
    EXPECT_EQ(acknowledge(), 190u);
    read(DATA);
    end(190);
    EXPECT_FALSE(board.irq);
    write(MASK, TX_EMPTY);
    EXPECT_TRUE(board.irq);
}

TEST_F(I2cController, StopsAfterTheByteWhenItIsDisabled) {
    write(DATA, 1);
    write(DATA, 2);
    wait_bits(5);
    write(EN, 0);
    EXPECT_EQ(read(EN_STAT) & 1, 1u);
    wait_bits(15);
    EXPECT_EQ(read(EN_STAT) & 1, 0u);
    EXPECT_THAT(device.heard, ElementsAre("write", "stop"));
}

TEST_F(I2cController, IsResetByTheResetManager) {
    write(DATA, 1);
    wait_bits(5);
    write(0xFFD05014, 1 << 12);
    write(0xFFD05014, 0);
    wait_bits(100);
    EXPECT_EQ(read(CON), 0x7Du);
    EXPECT_EQ(read(EN), 0u);
    EXPECT_EQ(device.heard.back(), "stop");
}

}  // namespace
