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
        settings = read_settings(folder / "p.qsf");
        return settings.assignments;
    }
    // What is said of a text that is refused.
    std::string refused(const std::string& text) {
        try {
            read(text);
        } catch (const sim::project::ProjectError& error) {
            return error.what();
        }
        return "taken";
    }

    sim::project::Settings settings;
};

TEST_F(Settings, HaveGlobalAndLocationAssignments) {
    const auto all = read(
        "# a comment\r\n"
        "set_global_assignment -name TOP_LEVEL_ENTITY \"my top\"\r\n"
        "set_location_assignment PIN_AB12 -to SW[0]\r\n"
        "set_global_assignment -name VERILOG_FILE {a b.v} ;# after it\n");
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
        "[file join $::quartus(qip_path) \"pll/pll_0002.v\"]\n"
        "set_global_assignment -name QIP_FILE [join [list $::quartus(qip_path) pll .qip] {}]\n");
    ASSERT_EQ(all.size(), 2u);
    EXPECT_EQ(all[0].value, "pll/pll_0002.v");
    EXPECT_TRUE(all[0].in_qip_folder);
    EXPECT_EQ(all[1].value, "pll.qip");
    EXPECT_TRUE(all[1].in_qip_folder);
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

TEST_F(Settings, AreTcl) {
    const auto all = read(
        "set parts {counter.v display.v}\n"
        "foreach part $parts {\n"
        "    set_global_assignment -name VERILOG_FILE [file join rtl $part]\n}\n"
        "proc pins {port first} { for {set i 0} {$i < 2} {incr i} {\n"
        "    set_location_assignment PIN_A[expr {$i + $first}] -to $port\\[$i\\] } }\n"
        "pins SW 3\n"
        "if {$::quartus(version) >= 18} { set_global_assignment -name NEW yes }\n"
        "set_location_assignment PIN_B1 -to LEDR[0] ; set_location_assignment PIN_B2 -to "
        "\"HEX0[1]\"\n"
        "set_instance_assignment -name X ON -to GPIO_0[3:0]\n"
        "set_instance_assignment -name X ON -to KEY[*]\n"
        "set_global_assignment -name VERILOG_FILE [file normalize [file join [file dirname a/b.v] "
        "c.v]]\n");
    ASSERT_EQ(all.size(), 10u);
    EXPECT_EQ(all[0].value, "rtl/counter.v");
    EXPECT_EQ(all[1].value, "rtl/display.v");
    EXPECT_EQ(all[1].line, 2u);
    EXPECT_EQ(all[3].value, "PIN_A4");
    EXPECT_EQ(all[3].to, "SW[1]");
    EXPECT_EQ(all[4].name, "NEW");
    EXPECT_EQ(all[5].to, "LEDR[0]");
    EXPECT_EQ(all[6].to, "HEX0[1]");
    EXPECT_EQ(all[7].to, "GPIO_0[3:0]");
    EXPECT_EQ(all[8].to, "KEY[*]");
    EXPECT_EQ(all[9].value, "a/c.v");
    EXPECT_TRUE(settings.notes.empty());
}

TEST_F(Settings, ABackslashInAPathIsNoEscape) {
    const auto all = read(
        "set_global_assignment -name VERILOG_FILE ..\\rtl\\new.v\n"
        "set_global_assignment -name VERILOG_FILE \"rtl\\a b.v\"\n");
    ASSERT_EQ(all.size(), 2u);
    EXPECT_EQ(all[0].value, "..\\rtl\\new.v");
    EXPECT_EQ(all[1].value, "rtl\\a b.v");
}

TEST_F(Settings, ABracketThatIsMissingIsAtTheEndOfItsWord) {
    const auto all = read(
        "set_location_assignment PIN_AG20 -to GPIO_1[22\nset_location_assignment "
        "PIN_AH20 -to GPIO_1[23]\n");
    ASSERT_EQ(all.size(), 2u);
    EXPECT_EQ(all[0].to, "GPIO_1[22]");
    ASSERT_EQ(settings.notes.size(), 1u);
    EXPECT_EQ(settings.notes[0],
              "p.qsf:1: a \"]\" is missing, and taken to be at the end of its word");
}

TEST_F(Settings, AWrongLineIsReportedWithItsFile) {
    EXPECT_EQ(refused("# one\nset a 1\nset_global_assignment -name X $nothing\n"),
              "p.qsf:3: this is wrong Tcl: can't read \"nothing\": no such variable");
    EXPECT_EQ(refused("\n\nset_global_assignment -name {X\n"),
              "p.qsf:3: this is wrong Tcl: missing close-brace");
    std::ofstream{folder / "pins.tcl"} << "set x 1\nif {$x} {\n";
    EXPECT_EQ(refused("source pins.tcl\n"), "pins.tcl:2: this is wrong Tcl: missing close-brace");
}

TEST_F(Settings, ACommandThatIsNotKnownIsPassedOver) {
    EXPECT_EQ(read("// not a comment\npackage require ::quartus::project\nset_user_option x y\n"
                   "set_global_assignment -name A [frobnicate b]\n")
                  .size(),
              1u);
    ASSERT_EQ(settings.notes.size(), 2u);
    EXPECT_EQ(settings.notes[0], "p.qsf:1: the command // is passed over");
}

TEST_F(Settings, AScriptReachesNothingElse) {
    std::ofstream{folder / "secret"} << "text";
    for (const char* command :
         {"open secret", "exec touch made", "socket localhost 80", "glob *", "exit", "cd ..",
          "file delete secret", "file copy secret made", "load libx.so", "interp create x"})
        refused(std::string{"catch { "} + command + " }\nset_global_assignment -name A b\n");
    EXPECT_TRUE(fs::exists(folder / "secret"));
    EXPECT_FALSE(fs::exists(folder / "made"));
    EXPECT_TRUE(read("set_global_assignment -name A [open secret]\n").at(0).value.empty());
}

TEST_F(Settings, AScriptWithoutAnEndEnds) {
    EXPECT_NE(refused("while {1} { set a 1 }\n").find("p.qsf:1: "), std::string::npos);
    EXPECT_NE(refused("proc f {} { f }\nf\n").find("p.qsf:2: "), std::string::npos);
}

TEST_F(Settings, AnyBytesAreReadOrRefused) {
    std::string bytes;
    for (int i = 0; i < 4096; ++i) bytes += static_cast<char>(i * 37);
    EXPECT_NE(refused(bytes + "{ \"\n[ \\").find("p.qsf:"), std::string::npos);
}

TEST_F(Settings, AFileThatIsNotThereIsAnError) {
    EXPECT_THROW(read_settings(folder / "none.qsf"), sim::project::ProjectError);
    EXPECT_THROW(read_settings(folder), sim::project::ProjectError);
}

}  // namespace
