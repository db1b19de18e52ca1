// The device's primitives for clocks and pins, by Intel's guides on ALTCLKCTRL and ALTIOBUF.

#include "Vdevice_bench.h"

#include <gmock/gmock.h>

namespace {

class Device : public testing::Test {
protected:
    Device() { dut.eval(); }

    void rise() {
        dut.clocks_i |= 1;
        dut.eval();
    }
    void fall() {
        dut.clocks_i &= ~1;
        dut.eval();
    }

    Vdevice_bench dut;
};

TEST_F(Device, ChoosesOneOfFourClocks) {
    for (unsigned select = 0; select < 4; ++select) {
        for (unsigned clocks = 0; clocks < 16; ++clocks) {
            dut.select_i = select;
            dut.clocks_i = clocks;
            dut.eval();
            EXPECT_EQ(dut.selected_o, clocks >> select & 1);
        }
    }
}

TEST_F(Device, LetsWholePulsesOfAClockThrough) {
    dut.ena_i = 1;
    rise();
    EXPECT_EQ(dut.gated_o, 5);  // powers up enabled, but the second one
    dut.ena_i = 0;
    dut.eval();
    EXPECT_EQ(dut.gated_o, 5);  // not cut
    dut.ena_i = 1;
    fall();
    rise();
    EXPECT_EQ(dut.gated_o, 5);
    fall();
    EXPECT_EQ(dut.enaout_o, 7);
    rise();
    EXPECT_EQ(dut.gated_o, 7);
    dut.ena_i = 0;
    fall();
    EXPECT_EQ(dut.gated_o, 0);
    EXPECT_EQ(dut.enaout_o, 6);
    rise();
    EXPECT_EQ(dut.gated_o, 6);
    fall();
    rise();
    EXPECT_EQ(dut.gated_o, 4);
    dut.ena_i = 1;
    dut.eval();
    EXPECT_EQ(dut.gated_o, 4);  // no short pulse
    EXPECT_EQ(dut.counts_o, 3);
}

TEST_F(Device, DrivesAPinWhereItsOutputIsEnabled) {
    dut.oe_i = 1;
    for (dut.i_i = 0; dut.i_i < 2; ++dut.i_i) {
        dut.eval();
        EXPECT_EQ(dut.pad_o, dut.i_i);
        EXPECT_EQ(dut.inside_o, dut.i_i);
        EXPECT_EQ(dut.pair_o, dut.i_i);
        EXPECT_EQ(dut.pair_bar_o, !dut.i_i);
    }
    dut.oe_i = 0;
    dut.drive_i = 1;
    for (dut.pin_i = 0; dut.pin_i < 2; ++dut.pin_i) {
        dut.eval();
        EXPECT_EQ(dut.pad_o, dut.pin_i);
        EXPECT_EQ(dut.inside_o, dut.pin_i);
    }
}

TEST_F(Device, LeavesAnOpenDrainToOthersAtA1) {
    dut.oe_i = 1;
    dut.eval();
    EXPECT_EQ(dut.drain_o, 0);
    dut.i_i = 1;
    dut.drive_i = 1;
    for (dut.pin_i = 0; dut.pin_i < 2; ++dut.pin_i) {
        dut.eval();
        EXPECT_EQ(dut.drain_o, dut.pin_i);
    }
}

}  // namespace
