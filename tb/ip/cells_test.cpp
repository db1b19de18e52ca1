// Double data rate cells, altshift_taps, altdpram, and the primitives, by Intel's help on each.

#include "Vcells_bench.h"

#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>

#include "sim/project/init_file.h"

namespace {

namespace fs = std::filesystem;

class Cells : public testing::Test {
protected:
    Cells() {
        fs::create_directories(folder);
        std::ofstream(folder / "small.mif") << "WIDTH=8; DEPTH=16; CONTENT BEGIN 2: 77; END;";
        sim::project::set_init_folders({folder, {}});
        dut.enable_i = dut.clrn_i = dut.prn_i = 1;
        dut.byteena_i = 3;
        dut.eval();
    }
    ~Cells() override { fs::remove_all(folder); }

    void rise() {
        dut.clock_i = 1;
        dut.eval();
    }
    void fall() {
        dut.clock_i = 0;
        dut.eval();
    }
    void clock() {
        rise();
        fall();
    }

    // The flip-flops of `cells` after a clock with these inputs.
    unsigned after(unsigned a, unsigned b, unsigned cells) {
        dut.a_i = a;
        dut.b_i = b;
        clock();
        return dut.cells_o & cells;
    }

    const fs::path folder =
        fs::path(testing::TempDir()) /
        (std::string("cells_") + testing::UnitTest::GetInstance()->current_test_info()->name());
    Vcells_bench dut;
};

TEST_F(Cells, SendTheHighWordWhileTheClockIsHigh) {
    dut.a_i = 5;
    dut.b_i = 10;
    rise();
    EXPECT_EQ(dut.ddr_o, 5);
    EXPECT_EQ(dut.clock_out_o, 0);
    dut.a_i = dut.b_i = 0;
    dut.eval();
    EXPECT_EQ(dut.ddr_o, 5);
    fall();
    EXPECT_EQ(dut.ddr_o, 10);
    EXPECT_EQ(dut.clock_out_o, 1);
    dut.enable_i = 0;
    clock();
    EXPECT_EQ(dut.ddr_o, 10);
    dut.aclr_i = 1;
    dut.eval();
    EXPECT_EQ(dut.ddr_o, 0);
}

TEST_F(Cells, ReceiveAWordPerEdgeAndShowBothAtTheRise) {
    rise();
    dut.a_i = 6;
    fall();
    EXPECT_EQ(dut.low_o, 0);
    dut.a_i = 9;
    rise();
    EXPECT_EQ(dut.high_o, 9);
    EXPECT_EQ(dut.low_o, 6);
}

TEST_F(Cells, DriveAPadOnlyWithOutputEnable) {
    dut.a_i = 5;
    dut.b_i = 10;
    dut.oe_i = 1;
    rise();
    EXPECT_EQ(dut.pad_o, 5);
    fall();
    EXPECT_EQ(dut.pad_o, 10);
    dut.oe_i = 0;
    dut.drive_i = 1;
    dut.pins_i = 3;
    dut.eval();
    EXPECT_EQ(dut.pad_o, 3);
    clock();
    EXPECT_EQ(dut.bidir_high_o, 3);
}

TEST_F(Cells, ShowWhatCameInThreeAndSixClocksAgo) {
    for (unsigned i = 1; i <= 20; ++i) {
        dut.a_i = i % 16;
        clock();
        const unsigned near = i >= 3 ? (i - 2) % 16 : 0;
        const unsigned far = i >= 6 ? (i - 5) % 16 : 0;
        EXPECT_EQ(dut.taps_o, far << 4 | near) << i;
        EXPECT_EQ(dut.shiftout_o, far);
    }
    const unsigned taps = dut.taps_o;
    dut.enable_i = 0;
    clock();
    EXPECT_EQ(dut.taps_o, taps);
    dut.aclr_i = 1;
    dut.eval();
    EXPECT_EQ(dut.taps_o, 0);
}

TEST_F(Cells, ReadASmallMemoryAtOnceOrRegistered) {
    dut.b_i = 2;
    dut.eval();
    EXPECT_EQ(dut.memory_o, 0x77);
    dut.a_i = 2;
    dut.wren_i = 1;
    clock();
    EXPECT_EQ(dut.memory_o, 0x22);
    EXPECT_EQ(dut.memory_later_o, 0);
    dut.wren_i = 0;
    clock();
    EXPECT_EQ(dut.memory_later_o, 0x22);
    dut.aclr_i = 1;
    dut.eval();
    EXPECT_EQ(dut.memory_later_o, 0);
    dut.aclr_i = 0;
    dut.a_i = dut.b_i = 4;
    dut.byteena_i = 2;
    dut.wren_i = 1;
    clock();
    EXPECT_EQ(dut.memory_o, 0x40);
}

TEST_F(Cells, SynchroniseInThreeClocks) {
    dut.a_i = 1;
    dut.b_i = 0;
    clock();
    dut.b_i = 1;
    clock();
    EXPECT_EQ(dut.dout_o, 0);
    clock();
    EXPECT_EQ(dut.dout_o, 1);
    clock();
    EXPECT_EQ(dut.dout_o, 3);
    dut.clrn_i = 0;
    dut.eval();
    EXPECT_EQ(dut.dout_o, 0);
}

TEST_F(Cells, AreInertWhereAComputerWouldBe) {
    EXPECT_EQ(dut.source_o, 0x5A);
    EXPECT_EQ(dut.tck_o, 0);
}

TEST_F(Cells, KeepABit) {
    constexpr unsigned D = 0x0F;
    EXPECT_EQ(after(1, 0, D), D);
    EXPECT_EQ(after(0, 0, D), 0u);
    dut.enable_i = 0;
    EXPECT_EQ(after(1, 0, D | 0x80), 1u);  // only dff has no enable
    dut.b_i = 3;
    dut.eval();
    EXPECT_EQ(dut.cells_o & D, 5u);  // dffea loads adata at once
    EXPECT_EQ(after(1, 3, D), 5u);
    dut.enable_i = 1;
    EXPECT_EQ(after(0, 5, 8), 8u);  // dffeas loads asdata
    dut.sclr_i = 1;
    EXPECT_EQ(after(1, 5, 8), 0u);
}

TEST_F(Cells, ToggleSetAndClear) {
    constexpr unsigned T = 0x10, JK = 0x20, SR = 0x40;
    EXPECT_EQ(after(1, 0, T | JK | SR), T | JK | SR);
    EXPECT_EQ(after(0, 0, T | JK | SR), T | JK | SR);
    EXPECT_EQ(after(0, 1, T | JK | SR), T);
    EXPECT_EQ(after(1, 1, T | JK | SR), JK | SR);
    EXPECT_EQ(after(1, 1, T | JK | SR), T);
}

TEST_F(Cells, ClearBeforeTheyPreset) {
    dut.prn_i = 0;
    dut.eval();
    EXPECT_EQ(dut.cells_o & 0x7F, 0x7Fu);
    dut.clrn_i = 0;
    dut.eval();
    EXPECT_EQ(dut.cells_o & 0x7F, 0u);
}

TEST_F(Cells, AreOpenWhileALatchIsEnabled) {
    dut.a_i = 1;
    dut.eval();
    EXPECT_EQ(dut.cells_o & 0x80, 0x80u);
    dut.enable_i = 0;
    dut.eval();
    dut.a_i = 0;
    dut.eval();
    EXPECT_EQ(dut.cells_o & 0x80, 0x80u);
}

TEST_F(Cells, AreWiresAndBuffers) {
    EXPECT_EQ(dut.wires_o, 8);
    dut.a_i = 1;
    dut.oe_i = 1;
    dut.eval();
    EXPECT_EQ(dut.wires_o, 0x37);
    EXPECT_TRUE(dut.tri_o && dut.iobuf_o && dut.inside_o);
    dut.oe_i = 0;
    dut.drive_i = 1;
    dut.eval();
    EXPECT_FALSE(dut.tri_o || dut.iobuf_o || dut.inside_o);
}

}  // namespace
