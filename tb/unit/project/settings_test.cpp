// Quartus' settings files, as its manual and its own files write them.
#include "sim/project/settings.h"

#include <fstream>

#include <gtest/gtest.h>

namespace {

namespace fs = std::filesystem;
using sim::project::Assignment;
using sim::project::read_settings;

class Settings : public ::testing::Test {
protected:
    fs::path folder = fs::path{::testing::TempDir()} /
                      ::testing::UnitTest::GetInstance()->current_test_info()->name();

    void SetUp() override { fs::create_directories(folder); }
    void TearDown() override { fs::remove_all(folder); }

    std::vector<Assignment> read(const std::string& text) {
        std::ofstream{folder / "p.qsf"} << text;
        return read_settings(folder / "p.qsf");
    }
};

TEST_F(Settings, HaveGlobalAndLocationAssignments) {
    const auto all = read(
        "# a comment\r\n"
        "set_global_assignment -name TOP_LEVEL_ENTITY \"my top\"\r\n"
        "set_location_assignment PIN_AB12 -to SW[0]\r\n"
        "set_global_assignment -name VERILOG_FILE {a b.v} ;# behind it\n");
    ASSERT_EQ(all.size(), 3u);
    EXPECT_EQ(all[0].name, "TOP_LEVEL_ENTITY");
    EXPECT_EQ(all[0].value, "my top");
    EXPECT_EQ(all[0].line, 2u);
    EXPECT_EQ(all[1].name, "LOCATION");
    EXPECT_EQ(all[1].value, "PIN_AB12");
    EXPECT_EQ(all[1].to, "SW[0]");
    EXPECT_EQ(all[2].value, "a b.v");
}

TEST_F(Settings, OptionsMayStandAnywhere) {
    const auto all = read(
        "set_instance_assignment -name IO_STANDARD \"3.3-V LVTTL\" -to LEDR -entity top\n"
        "set_location_assignment -to KEY\\[0\\] PIN_AA14\n"
        "set_global_assignment -section_id x -name VERILOG_FILE \\\n  other.v\n");
    ASSERT_EQ(all.size(), 3u);
    EXPECT_EQ(all[0].value, "3.3-V LVTTL");
    EXPECT_EQ(all[0].to, "LEDR");
    EXPECT_EQ(all[1].value, "PIN_AA14");
    EXPECT_EQ(all[1].to, "KEY[0]");
    EXPECT_EQ(all[2].value, "other.v");
}

TEST_F(Settings, ValuesInAQipAreRelativeToIt) {
    const auto all = read(
        "set_global_assignment -library \"pll\" -name VERILOG_FILE "
        "[file join $::quartus(qip_path) \"pll/pll_0002.v\"]\n");
    ASSERT_EQ(all.size(), 1u);
    EXPECT_EQ(all[0].value, "pll/pll_0002.v");
    EXPECT_TRUE(all[0].in_qip_folder);
}

TEST_F(Settings, AreTakenFromSourcedFiles) {
    std::ofstream{folder / "pins.tcl"} << "set_location_assignment PIN_AF14 -to CLOCK_50\n";
    const auto all = read("source pins.tcl\nsource missing.tcl\n");
    ASSERT_EQ(all.size(), 1u);
    EXPECT_EQ(all[0].file.filename(), "pins.tcl");
}

TEST_F(Settings, WhatIsRemovedDoesNotCount) {
    std::ofstream{folder / "common.qsf"} << "set_global_assignment -name VERILOG_FILE a.v\n"
                                            "set_global_assignment -name VERILOG_FILE b.v\n"
                                            "set_location_assignment PIN_AF14 -to CLOCK_50\n"
                                            "set_location_assignment PIN_AB12 -to SW[0]\n";
    const auto all = read(
        "source common.qsf\n"
        "set_global_assignment -remove -name VERILOG_FILE a.v\n"
        "set_location_assignment -remove -to SW[0]\n"
        "set_global_assignment -name VERILOG_FILE c.v\n");
    ASSERT_EQ(all.size(), 3u);
    EXPECT_EQ(all[0].value, "b.v");
    EXPECT_EQ(all[1].to, "CLOCK_50");
    EXPECT_EQ(all[2].value, "c.v");
}

TEST_F(Settings, WhatIsDisabledDoesNotCount) {
    const auto all = read(
        "set_global_assignment -name VERILOG_FILE old.v -disable\n"
        "set_global_assignment -disable -name VERILOG_FILE older.v\n"
        "set_global_assignment -name VERILOG_FILE new.v\n");
    ASSERT_EQ(all.size(), 1u);
    EXPECT_EQ(all[0].value, "new.v");
}

TEST_F(Settings, FilesThatSourceThemselvesEnd) {
    EXPECT_TRUE(read("source p.qsf\n").empty());
    std::string many;
    for (unsigned i = 0; i < 100; ++i) many += "source p.qsf\n";  // 100^8 readings
    EXPECT_THROW(read(many), sim::project::ProjectError);
}

TEST_F(Settings, AnyBytesAreRead) {
    std::string bytes;
    for (int i = 0; i < 4096; ++i) bytes += static_cast<char>(i * 37);
    EXPECT_NO_THROW(read(bytes + "{ \"\n[ \\"));
}

TEST_F(Settings, AFileThatIsNotThereIsAnError) {
    EXPECT_THROW(read_settings(folder / "none.qsf"), sim::project::ProjectError);
    EXPECT_THROW(read_settings(folder), sim::project::ProjectError);
}

}  // namespace
