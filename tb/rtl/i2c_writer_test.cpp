// i2c_writer.v on a bus that checks every edge against the I2C standard.
#include <gmock/gmock.h>

#include "Vi2c_writer.h"
#include "tb/rtl/i2c_bus.h"
#include "tb/support/random_registers.h"

namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

using Bytes = std::vector<std::uint8_t>;

class I2cWriter : public ::testing::Test {
protected:
    static void SetUpTestSuite() { tb::start_with_random_registers(); }
    void SetUp() override {
        dut.rst_i = 1;
        dut.start_i = 0;
        dut.sdat_i = 1;
        for (int i = 0; i < 2; ++i) {  // as many as the synchroniser has flip-flops
            dut.clk_i = 0;
            dut.eval();
            dut.clk_i = 1;
            dut.eval();
        }
        dut.rst_i = 0;
    }
    void TearDown() override { EXPECT_THAT(bus.faults, IsEmpty()); }

    void clock() {
        dut.clk_i = 0;
        dut.eval();
        dut.clk_i = 1;
        dut.eval();
        bus.step(dut.sclk_o, dut.sdat_oe_o);
        dut.sdat_i = bus.sda();
    }
    // Whether all bytes were acknowledged, as the module says.
    bool write(std::uint16_t word, std::uint8_t slave = 0x1a) {
        dut.start_i = 1;
        dut.slave_i = slave;
        dut.word_i = word;
        clock();
        dut.start_i = 0;
        dut.slave_i = 0;
        dut.word_i = 0;
        int clocks = 0;
        while (!dut.done_o && clocks++ < 20'000) clock();
        EXPECT_TRUE(dut.done_o) << "no end";
        EXPECT_FALSE(dut.busy_o);
        const bool ok = !dut.nack_o;
        clock();
        EXPECT_FALSE(dut.done_o) << "done for more than a clock";
        EXPECT_TRUE(bus.idle());
        return ok;
    }

    Vi2c_writer dut;
    tb::I2cBus bus;
};

TEST_F(I2cWriter, SendsAddressAndTwoBytesMsbFirst) {
    EXPECT_TRUE(write(0x12c4));
    EXPECT_TRUE(write(0x8001, 0x65));
    EXPECT_THAT(bus.transfers, ElementsAre(Bytes{0x34, 0x12, 0xc4}, Bytes{0xca, 0x80, 0x01}));
    EXPECT_EQ(bus.stops, 2u);
}

TEST_F(I2cWriter, SendsOneWordAfterTheOther) {
    for (unsigned word = 0; word < 16; ++word) {
        const std::uint16_t value = static_cast<std::uint16_t>(1u << word);
        EXPECT_TRUE(write(value));
        EXPECT_EQ(bus.transfers.back(), (Bytes{0x34, static_cast<std::uint8_t>(value >> 8),
                                               static_cast<std::uint8_t>(value)}));
    }
    EXPECT_EQ(bus.transfers.size(), 16u);
    EXPECT_EQ(bus.stops, 16u);
}

TEST_F(I2cWriter, StopsAfterAByteWithoutAcknowledge) {
    for (std::size_t byte = 0; byte < 3; ++byte) {
        bus.refuse(bus.transfers.size(), byte);
        EXPECT_FALSE(write(0xa55a)) << "byte " << byte;
        EXPECT_EQ(bus.transfers.back().size(), byte + 1);
        EXPECT_TRUE(write(0x5aa5)) << "the word after";
    }
    EXPECT_EQ(bus.stops, 6u);
}

TEST_F(I2cWriter, LeavesTheBusAloneWhileIdle) {
    for (int i = 0; i < 5000; ++i) {
        clock();
        ASSERT_TRUE(bus.idle());
        ASSERT_FALSE(dut.busy_o);
    }
    EXPECT_THAT(bus.transfers, IsEmpty());
}

TEST_F(I2cWriter, SendsAWordIn292Microseconds) {
    int clocks = 0;
    dut.start_i = 1;
    clock();
    dut.start_i = 0;
    while (!dut.done_o && clocks < 20'000) clock(), ++clocks;
    EXPECT_EQ(clocks, 29 * 4 * 63);  // quarters of START, 27 bits and STOP
}

}  // namespace
