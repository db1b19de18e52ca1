// wrong_address_test.cpp - an access that nothing answers ends the firmware, and nothing else.
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
        EXPECT_THAT(board->cpu.fault().value_or("no fault"), MatchesRegex(fault));
        EXPECT_EQ(board->bus.counts().errors, 1u);
        next_picture();  // the FPGA goes on
        next_picture();
    }
};

TEST_F(WrongAddress, BetweenTheRegistersIsADataAbortWithAddressAndTime) {
    abort_with([](hal::Mmio& io, hal::Cpu&) { io.read(0xFF2FF000); },
               "data abort: read of 4 bytes at 0xFF2FF000 at 2\\.000[0-9]* ms .*");
}

TEST_F(WrongAddress, BehindThePicturesIsADataAbortWithAddressAndTime) {
    abort_with([](hal::Mmio& io, hal::Cpu&) { io.write(0xC4000000, 1); },
               "data abort: write of 4 bytes at 0xC4000000 at 2\\.000[0-9]* ms .*");
}

TEST_F(WrongAddress, WhereTheBoardHasNothingIsADataAbortWithAddressAndTime) {
    abort_with([](hal::Mmio& io, hal::Cpu&) { io.read(0x80000000); },
               "data abort: read of 4 bytes at 0x80000000 at 2\\.000[0-9]* ms .*");
}

TEST_F(WrongAddress, InTheMiddleOfABurstIsADataAbortOfTheBurst) {
    abort_with(
        [](hal::Mmio& io, hal::Cpu&) {
            const std::uint32_t words[32] = {};
            io.write_words(0xC8080000 - 64, words, 32);  // half of it behind PICTURE0
        },
        "data abort: write of 128 bytes at 0xC807FFC0 at 2\\.00[0-9]* ms .*");
}

}  // namespace
