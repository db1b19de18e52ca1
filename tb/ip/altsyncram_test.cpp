// altsyncram, by Intel's "Embedded Memory User Guide" (683240) and the Cyclone V handbook.

#include "Valtsyncram_bench.h"

#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "sim/project/init_file.h"

namespace {

namespace fs = std::filesystem;

class Altsyncram : public testing::Test {
protected:
    Altsyncram() {
        fs::create_directories(folder / "quartus");
        write("words.mif", "WIDTH=8; DEPTH=6; CONTENT BEGIN 0: 10 11 12 13 14 15; END;");
        write("quartus/wide.mif", "WIDTH=32; DEPTH=8; CONTENT BEGIN [0..7]: 44332211; END;");
        write("quartus/deep/words.hex", ":050001000102030405EB\n:00000001FF\n");
        sim::project::set_init_folders(
            {folder / "quartus", {}}, [this](const std::string& text) { missing.push_back(text); });
        dut.clocken_i = 15;
        dut.byteena_a_i = 15;
        dut.rden_a_i = dut.rden_b_i = 1;
        dut.eval();
    }
    ~Altsyncram() override { fs::remove_all(folder); }

    void write(const std::string& name, const std::string& text) const {
        fs::create_directories((folder / name).parent_path());
        std::ofstream(folder / name) << text;
    }

    // Rising edges of the clocks in `which`, at the same time.
    void clock(unsigned which = 1) {
        dut.clock_i = which;
        dut.eval();
        dut.clock_i = 0;
        dut.eval();
    }

    // A word is written through port A, and wren is low again.
    void write_a(unsigned address, unsigned data) {
        dut.address_a_i = address;
        dut.data_a_i = data;
        dut.wren_a_i = 1;
        clock();
        dut.wren_a_i = 0;
    }

    const fs::path folder = fs::path(testing::TempDir()) /
                            (std::string("altsyncram_") +
                             testing::UnitTest::GetInstance()->current_test_info()->name());
    std::vector<std::string> missing;
    Valtsyncram_bench dut;
};

TEST_F(Altsyncram, ReadsARomWhoseClockEnableIsPulledUp) {
    for (unsigned address = 0; address < 6; ++address) {
        dut.address_a_i = address;
        dut.eval();
        EXPECT_EQ(dut.rom_o, address ? 0x10 + address - 1 : 0);
        clock();
        EXPECT_EQ(dut.rom_o, 0x10 + address);
    }
}

TEST_F(Altsyncram, FillsWordsOfMoreThan32BitsFromIntelHex) {
    dut.address_b_i = 1;
    clock();
    EXPECT_EQ(dut.hex_o, 0x0102030405u);
}

TEST_F(Altsyncram, ReportsWhichFileIsMissingAndIsZero) {
    ASSERT_EQ(missing.size(), 1u);
    EXPECT_THAT(missing[0], testing::StartsWith("missing.mif: not found"));
    EXPECT_THAT(missing[0], testing::HasSubstr("altsyncram_bench.both"));
    clock(3);
    EXPECT_EQ(dut.true_a_o, 0);
}

TEST_F(Altsyncram, ShowsAWordOneClockLaterWithAnOutputRegister) {
    write_a(3, 0xABCD);
    clock();
    EXPECT_EQ(dut.bytes_o, 0xABCD);
    dut.address_a_i = 4;
    clock();
    EXPECT_EQ(dut.bytes_o, 0xABCD);
    clock();
    EXPECT_EQ(dut.bytes_o, 0);
}

TEST_F(Altsyncram, WritesOnlyTheBytesThatAreEnabled) {
    write_a(3, 0x1122);
    dut.byteena_a_i = 2;
    write_a(3, 0xAABB);
    clock();
    EXPECT_EQ(dut.bytes_o, 0xAA22);
    dut.byteena_a_i = 0;
    write_a(3, 0);
    clock();
    EXPECT_EQ(dut.bytes_o, 0xAA22);
}

TEST_F(Altsyncram, HoldsTheOutputRegisterWithoutItsClockEnable) {
    write_a(3, 0x1122);
    dut.clocken_i = 0;
    clock();
    EXPECT_EQ(dut.bytes_o, 0);
    dut.clocken_i = 1;
    clock();
    EXPECT_EQ(dut.bytes_o, 0x1122);
}

TEST_F(Altsyncram, ClearsTheOutputRegisterAtOnce) {
    write_a(3, 0x1122);
    clock();
    dut.aclr_i = 1;
    dut.eval();
    EXPECT_EQ(dut.bytes_o, 0);
    clock();
    EXPECT_EQ(dut.bytes_o, 0);
    dut.aclr_i = 0;
    clock();
    EXPECT_EQ(dut.bytes_o, 0x1122);
}

TEST_F(Altsyncram, ClearsTheOutputLatchWhereThereIsNoRegister) {
    write_a(3, 0x42);
    clock();
    EXPECT_EQ(dut.old_o, 0x42);
    dut.aclr_i = 2;
    dut.eval();
    EXPECT_EQ(dut.old_o, 0);
    dut.aclr_i = 0;
    clock();
    EXPECT_EQ(dut.old_o, 0x42);
}

TEST_F(Altsyncram, ReadsTheOldOrTheNewDataWhileItWrites) {
    write_a(3, 0x42);
    EXPECT_EQ(dut.old_o, 0);
    EXPECT_EQ(dut.new_o, 0x42);
    write_a(3, 0x43);
    EXPECT_EQ(dut.old_o, 0x42);
    EXPECT_EQ(dut.new_o, 0x43);
}

TEST_F(Altsyncram, KeepsItsOutputWithoutReadEnable) {
    write_a(3, 0x42);
    clock();
    dut.rden_a_i = 0;
    dut.address_a_i = 5;
    clock();
    EXPECT_EQ(dut.old_o, 0x42);
    write_a(3, 0x43);
    EXPECT_EQ(dut.new_o, 0x42);
    dut.rden_a_i = 1;
    clock();
    EXPECT_EQ(dut.new_o, 0x43);
}

TEST_F(Altsyncram, DoesNothingWithoutItsClockEnable) {
    dut.clocken_i = 15 - 1;
    write_a(3, 0x42);
    EXPECT_EQ(dut.new_o, 0x42);  // whose enable is the alternative one
    dut.clocken_i = 15 - 4;
    clock();
    EXPECT_EQ(dut.old_o, 0);
    write_a(3, 0x43);
    EXPECT_EQ(dut.new_o, 0x42);
}

TEST_F(Altsyncram, KeepsTheAddressWhileItIsStalled) {
    write_a(3, 0x42);
    write_a(4, 0x43);
    dut.stall_a_i = 1;
    dut.address_a_i = 3;
    clock();
    EXPECT_EQ(dut.old_o, 0x43);
    dut.stall_a_i = 0;
    clock();
    EXPECT_EQ(dut.old_o, 0x42);
}

TEST_F(Altsyncram, PutsTheLowestNarrowWordIntoTheLowestBits) {
    dut.address_b_i = 2;
    for (unsigned i = 0; i < 4; ++i) write_a(8 + i, 0xA0 + i);
    clock(2);
    clock(2);
    EXPECT_EQ(dut.wide_o, 0xA3A2A1A0);
}

TEST_F(Altsyncram, ReadsTheInitFileOfADualPortMemoryAsPortBs) {
    dut.address_b_i = 7;
    clock(2);
    EXPECT_EQ(dut.wide_o, 0u);
    clock(2);
    EXPECT_EQ(dut.wide_o, 0x44332211u);
    dut.aclr_i = 2;
    dut.eval();
    EXPECT_EQ(dut.wide_o, 0u);
}

TEST_F(Altsyncram, HasReadEnableStallAndOutputEnableAtPortB) {
    dut.clocken_i = 15 - 2;
    clock(2);
    clock(2);
    EXPECT_EQ(dut.wide_o, 0u);
    dut.clocken_i = 15;
    clock(2);
    EXPECT_EQ(dut.wide_o, 0x44332211u);
    write_a(4, 0);
    dut.address_b_i = 1;
    dut.stall_b_i = 1;
    clock(2);
    clock(2);
    EXPECT_EQ(dut.wide_o, 0x44332211u);
    dut.stall_b_i = 0;
    dut.rden_b_i = 0;
    clock(2);
    clock(2);
    EXPECT_EQ(dut.wide_o, 0x44332211u);
    dut.rden_b_i = 1;
    clock(2);
    clock(2);
    EXPECT_EQ(dut.wide_o, 0x44332200u);
}

TEST_F(Altsyncram, WritesAndReadsAtBothPortsWithTwoClocks) {
    write_a(2, 0x1234);
    dut.address_b_i = 5;
    clock(2);
    EXPECT_EQ(dut.true_b_o, 0x12);
    dut.data_b_i = 0x56;
    dut.wren_b_i = 1;
    clock(2);
    EXPECT_EQ(dut.true_b_o, 0x12);
    dut.wren_b_i = 0;
    clock();
    EXPECT_EQ(dut.true_a_o, 0x5634);
}

TEST_F(Altsyncram, ReadsTheOldDataOfTheOtherPort) {
    dut.address_a_i = 2;
    dut.address_b_i = 4;
    dut.data_a_i = 0x1234;
    dut.wren_a_i = 1;
    clock(3);
    EXPECT_EQ(dut.true_a_o, 0x1234);
    EXPECT_EQ(dut.true_b_o, 0);
    clock(3);
    EXPECT_EQ(dut.true_b_o, 0x34);
}

TEST_F(Altsyncram, BacksTheMemoriesOfTheLpmLibrary) {
    dut.address_a_i = 4;
    clock(1);
    EXPECT_EQ(dut.lpm_rom_o, 0);
    clock(2);
    EXPECT_EQ(dut.lpm_rom_o, 0x14);
    write_a(4, 0x42);
    EXPECT_EQ(dut.lpm_ram_o, 0x42);
    dut.address_a_i = 5;
    clock();
    EXPECT_EQ(dut.lpm_ram_o, 0);
}

TEST_F(Altsyncram, EndsWithTheMessageOfAFileThatIsBroken) {
    write("words.mif", "WIDTH=8; DEPTH=6;\nCONTENT BEGIN 0: 1FF; END;");
    Valtsyncram_bench broken;
    try {
        broken.eval();
        FAIL() << "not refused";
    } catch (const std::runtime_error& error) {
        EXPECT_THAT(error.what(),
                    testing::HasSubstr("words.mif:2: \"1FF\", expected at most 8 bits"));
    }
}

}  // namespace
