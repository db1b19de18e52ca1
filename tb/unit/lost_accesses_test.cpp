// lost_accesses.h: messages about writes and reads without effect.
#include <gmock/gmock.h>

#include <string>

#include "regmap.h"
#include "sim/chip/lost_accesses.h"

namespace {

using ::testing::HasSubstr;

class LostAccesses : public ::testing::Test {
protected:
    sim::LostAccesses lost{0xC0000000};

    std::string write(std::uint32_t address, unsigned bytes = 4) {
        return lost.look(address, bytes, true).value_or("");
    }
    std::string read(std::uint32_t address, unsigned bytes = 4) {
        return lost.look(address, bytes, false).value_or("");
    }
};

TEST_F(LostAccesses, AreThoseToJp2WhereItIsNot) {
    EXPECT_EQ(write(regmap::JP2_DATA), "");
    sim::LostAccesses without{0xC0000000, false};
    EXPECT_THAT(without.look(regmap::JP2_DATA, 4, true).value_or(""),
                HasSubstr("no block is there"));
    EXPECT_EQ(without.look(regmap::JP1_DATA, 4, true), std::nullopt);
}

TEST_F(LostAccesses, AreReportedOncePerDirection) {
    EXPECT_EQ(write(0xC803FFFC), "");
    EXPECT_EQ(
        write(0xC8040000),
        "wrote 0xC8040000: no memory is there; on the board, too, the interconnect sends it to "
        "the SDRAM at 0xC0040000");
    EXPECT_EQ(write(0xC8041000), "");
    EXPECT_EQ(
        read(0xC807FFFE, 2),
        "read 0xC807FFFE: no memory is there; on the board, too, the interconnect sends it to "
        "the SDRAM at 0xC007FFFE");
    EXPECT_EQ(read(0xC8040000), "");
    EXPECT_THAT(write(0xC4000000), HasSubstr("the SDRAM at 0xC0000000"));
    EXPECT_THAT(write(0xC9002000), HasSubstr("the SDRAM at 0xC1002000"));
}

TEST_F(LostAccesses, WhereTheMemoriesRepeatAreReported) {
    EXPECT_EQ(write(0xD0000010),
              "wrote 0xD0000010: addresses repeat each 256 MB; on the board, too, it is SDRAM at "
              "0xC0000010");
    EXPECT_EQ(write(0xD8000000), "") << "once";
    EXPECT_THAT(read(0xE8000004), HasSubstr("ONCHIP at 0xC8000004"));
}

TEST_F(LostAccesses, AreThoseOfABurstThatRunsOverTheEnd) {
    EXPECT_EQ(write(0xC803FFC0, 64), "");
    EXPECT_THAT(write(0xC803FFE0, 64), HasSubstr("wrote 0xC8040000: "));
}

TEST_F(LostAccesses, AreNoneInTheMemories) {
    for (const std::uint32_t address :
         {0xC0000000u, 0xC3FFFFFCu, 0xC8000000u, 0xC9000000u, 0xC9000050u, 0xC9001FFCu}) {
        EXPECT_EQ(write(address), "");
        EXPECT_EQ(read(address), "");
    }
}

TEST_F(LostAccesses, AreWhereABlockHasNoRegister) {
    EXPECT_EQ(write(0xFF200054), "wrote 0xFF200054: KEY has no register there; the write is lost");
    EXPECT_EQ(read(0xFF200055, 1), "read 0xFF200054: KEY has no register there; it reads 0");
    EXPECT_THAT(write(0xFF202018), HasSubstr("TIMER0 has no register there"));
    EXPECT_THAT(write(0xFF202038), HasSubstr("TIMER1 has no register there"));
}

TEST_F(LostAccesses, AreWritesToReadOnlyRegisters) {
    EXPECT_EQ(write(0xFF200050), "wrote 0xFF200050: KEY_DATA is read-only; the write is lost");
    EXPECT_EQ(write(0xFF203028),
              "wrote 0xFF203028: PIXEL_RESOLUTION is read-only; the write is lost");
    EXPECT_EQ(read(0xFF200050), "");
}

TEST_F(LostAccesses, AreNoneAtRegisters) {
    for (const regmap::Reg& reg : regmap::REGS) {
        EXPECT_EQ(read(reg.addr), "") << reg.name;
        if (reg.access == regmap::Access::RO) continue;
        EXPECT_EQ(write(reg.addr), "") << reg.name;
    }
}

TEST_F(LostAccesses, BetweenTheBlocksGoToTheFirstTimer) {
    EXPECT_EQ(read(0xFF200080),
              "read 0xFF200080: no block is there; on the board, too, the interconnect sends it to "
              "TIMER0_STATUS");
    EXPECT_EQ(read(0xFF200090), "") << "once per gap";
    EXPECT_THAT(read(0xFF200110), HasSubstr("TIMER0_SNAP_LOW"));
    EXPECT_THAT(write(0xFF201018), HasSubstr("TIMER0, where it has no register"));
}

TEST_F(LostAccesses, AreWritesToBlocksThatCanOnlyBeRead) {
    EXPECT_EQ(write(0xFF200040),
              "wrote 0xFF200040: SW_DATA cannot be written; on the board, too, the interconnect "
              "sends it to TIMER0_STATUS");
    EXPECT_EQ(read(0xFF200040), "");
}

TEST_F(LostAccesses, WhereTheRegistersRepeatAreReported) {
    EXPECT_EQ(write(0xFF208000),
              "wrote 0xFF208000: addresses repeat each 32 KB; on the board, too, it is LEDR_DATA");
    EXPECT_THAT(read(0xFF2FF000), HasSubstr("no block is there"));
}

}  // namespace
