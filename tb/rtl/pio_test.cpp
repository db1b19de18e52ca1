// pio.v, 8 bits wide with everything: the parallel ports of the DE1-SoC Computer.
#include <gtest/gtest.h>

#include "Vpio.h"
#include "regmap.h"
#include "tb/support/register_bus.h"

namespace {

constexpr std::uint32_t DATA = regmap::JP1_DATA, DIR = regmap::JP1_DIR, MASK = regmap::JP1_MASK,
                        EDGE = regmap::JP1_EDGE;

class Pio : public tb::RegisterBus<Vpio> {
protected:
    void SetUp() override {
        dut.pins_i = 0xff;
        reset();
        clock(4);
    }
    void pins(std::uint8_t levels) {
        dut.pins_i = levels;
        clock(4);
    }
};

TEST_F(Pio, DrivesWhatWasWrittenWhereDirectionIsOut) {
    write(DIR, 0xf0);
    write(DATA, 0xa5);
    EXPECT_EQ(dut.pins_o, 0xa5);
    EXPECT_EQ(dut.oe_o, 0xf0);
    EXPECT_EQ(read(DIR), 0xf0u);
}

TEST_F(Pio, IsAllInputsAfterReset) {
    EXPECT_EQ(dut.oe_o, 0);
    EXPECT_EQ(read(MASK), 0u);
    EXPECT_EQ(read(EDGE), 0u);
    EXPECT_EQ(dut.irq_o, 0);
}

TEST_F(Pio, ReadsThePinsNotTheOutputRegister) {
    write(DIR, 0xff);
    write(DATA, 0x00);
    pins(0x3c);
    EXPECT_EQ(read(DATA), 0x3cu);
}

TEST_F(Pio, PassesPinsThroughTwoFlipFlops) {
    dut.pins_i = 0x00;
    clock();
    EXPECT_EQ(read(DATA), 0xffu);
    EXPECT_EQ(read(DATA), 0x00u);
}

TEST_F(Pio, CapturesFallingEdgesOnlyAndKeepsThem) {
    pins(0x7e);
    pins(0xff);
    EXPECT_EQ(read(EDGE), 0x81u);
}

TEST_F(Pio, ClearsOnlyTheEdgesWrittenAsOne) {
    pins(0x00);
    write(EDGE, 0x0f);
    EXPECT_EQ(read(EDGE), 0xf0u);
}

TEST_F(Pio, InterruptsWhileAMaskedEdgeIsSet) {
    pins(0xfe);
    EXPECT_EQ(dut.irq_o, 0);
    write(MASK, 0x02);
    EXPECT_EQ(dut.irq_o, 0);
    write(MASK, 0x01);
    EXPECT_EQ(dut.irq_o, 1);
    write(EDGE, 0x01);
    EXPECT_EQ(dut.irq_o, 0);
}

TEST_F(Pio, KeepsAnEdgeThatComesWhileOthersAreCleared) {
    pins(0xfe);
    dut.pins_i = 0xfc;
    clock(2);  // the synchroniser
    write(EDGE, 0x01);
    clock(2);
    EXPECT_EQ(read(EDGE), 0x02u);
}

TEST_F(Pio, LosesAnEdgeInTheClockOfItsClear) {
    dut.pins_i = 0xfe;
    clock(2);  // the synchroniser
    write(EDGE, 0x01);
    clock(2);
    EXPECT_EQ(read(EDGE), 0x00u);
}

TEST_F(Pio, IgnoresAWriteWithoutItsByteLane) {
    write(DATA, 0x55);
    write(DATA, 0xaaaaaaaa, 0xe);
    EXPECT_EQ(dut.pins_o, 0x55);
}

TEST_F(Pio, AnswersZeroWhenItWasNotAsked) {
    read(DATA);
    clock(1);
    EXPECT_EQ(dut.rdata_o, 0u);
}

}  // namespace
