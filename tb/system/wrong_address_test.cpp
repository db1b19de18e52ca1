// wrong_address_test.cpp - an access without a target ends the firmware, and nothing else.
#include <gmock/gmock.h>

#include "tb/support/whole_board.h"

namespace {

using ::testing::MatchesRegex;

class WrongAddress : public tb::WholeBoard {
protected:
    void abort_with(const sim::Firmware& access, const std::string& fault) {
        bool after = false;
        power_on([&](hal::Mmio& io, hal::Cpu& cpu) {
            idle_ms(cpu, 2);
            access(io, cpu);
            after = true;
        });
        run_ms(3);
        EXPECT_FALSE(after);
        EXPECT_THAT(computer->cpu.fault().value_or("no fault"), MatchesRegex(fault));
        EXPECT_EQ(computer->bus.counts().errors, 1u);
        next_picture();  // the FPGA goes on
        next_picture();
    }
};

TEST_F(WrongAddress, OnABridgeGoesWhereTheBoardsInterconnectSendsIt) {
    std::uint32_t sdram = 0, period = 0;
    power_on([&](hal::Mmio& io, hal::Cpu& cpu) {
        idle_ms(cpu, 2);
        io.write(0xFF200088, 0x1234);  // between the ports: the first timer's PERIOD_LOW
        period = io.read(0xFF202008);
        io.write(0xC8080000, 77);
        sdram = io.read(0xC0080000);
    });
    run_ms(3);
    EXPECT_FALSE(computer->cpu.fault());
    EXPECT_EQ(period, 0x1234u);
    EXPECT_EQ(sdram, 77u);
}

TEST_F(WrongAddress, InAnUnmodelledHpsBlockNamesTheBlock) {
    abort_with([](hal::Mmio& io, hal::Cpu&) { io.read(0xFFC00010); },
               "data abort: read of 4 bytes at 0xFFC00010 at 2\\.000[0-9]* ms "
               "\\(CAN0, 0xFFC00000 to 0xFFC00FFF, "
               "is not modelled\\)");
}

TEST_F(WrongAddress, InABridgeInResetIsADataAbort) {
    abort_with(
        [](hal::Mmio& io, hal::Cpu&) {
            io.write(0xFFD0501C, 2);
            io.read(0xFF200000);
        },
        "data abort: read of 4 bytes at 0xFF200000 at 2\\.000[0-9]* ms "
        "\\(the lightweight bridge is in reset: on the board the processor hangs here\\)");
}

TEST_F(WrongAddress, WithAWrongSizeIsADataAbort) {
    abort_with(
        [](hal::Mmio& io, hal::Cpu&) {
            const std::uint32_t words[2] = {};
            io.write_words(0xFFFEC200, words, 2);
        },
        "data abort: write of 8 bytes at 0xFFFEC200 at 2\\.000[0-9]* ms "
        "\\(the A9's global timer takes no writes of 8 bytes at 0xFFFEC200: aligned words only\\)");
}

TEST_F(WrongAddress, IsADataAbortWithAddressAndTime) {
    abort_with([](hal::Mmio& io, hal::Cpu&) { io.read(0x80000000); },
               "data abort: read of 4 bytes at 0x80000000 at 2\\.000[0-9]* ms "
               "\\(no memory at 0x80000000: [A-Z0-9]+ begins at 0xC0000000\\)");
}

TEST_F(WrongAddress, AfterTheDdr3IsADataAbortNamingItsEnd) {
    abort_with([](hal::Mmio& io, hal::Cpu&) { io.write(0x40000000, 0); },
               "data abort: write of 4 bytes at 0x40000000 at 2\\.000[0-9]* ms "
               "\\(no memory at 0x40000000: the DDR3 ends at 0x3FFFFFFF\\)");
}

TEST_F(WrongAddress, WithinABurstAbortsTheBurst) {
    abort_with(
        [](hal::Mmio& io, hal::Cpu&) {
            const std::uint32_t words[32] = {};
            io.write_words(0x40000000 - 64, words, 32);  // half of it after the DDR3
        },
        "data abort: write of 128 bytes at 0x3FFFFFC0 at 2\\.00[0-9]* ms "
        "\\(the DDR3 ends at 0x3FFFFFFF\\)");
}

}  // namespace
