// The SDRAM chip: its bursts, and each rule of its datasheet broken once.  100 MHz, CL 2 or 3.
#include "sim/board/is42s16320d.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

constexpr std::uint64_t CLOCK_PS = 10'000, US_PS = 1'000'000;
constexpr std::uint16_t ALL = 0x400;

class Sdram : public ::testing::Test {
protected:
    sim::Is42s16320d chip;
    std::uint64_t now = 0;

    void edge(sim::Is42s16320d::Pins pins) {
        chip.clock(pins, now);
        now += CLOCK_PS;
    }
    void nop(unsigned count = 1) {
        while (count--) edge({true, true, true, true, 0, 0, 0, false, 0});
    }
    void active(unsigned bank, unsigned row) {
        edge({false, false, true, true, static_cast<std::uint8_t>(bank),
              static_cast<std::uint16_t>(row), 0, false, 0});
    }
    void read(unsigned bank, unsigned column, std::uint8_t mask = 0) {
        edge({false, true, false, true, static_cast<std::uint8_t>(bank),
              static_cast<std::uint16_t>(column), mask, false, 0});
    }
    void write(unsigned bank, unsigned column, std::uint16_t word, std::uint8_t mask = 0) {
        edge({false, true, false, false, static_cast<std::uint8_t>(bank),
              static_cast<std::uint16_t>(column), mask, true, word});
    }
    void more(std::uint16_t word, std::uint8_t mask = 0) {  // of a burst written
        edge({true, true, true, true, 0, 0, mask, true, word});
    }
    void precharge(unsigned bank_or_all) {
        edge({false, false, true, false, static_cast<std::uint8_t>(bank_or_all & 3),
              static_cast<std::uint16_t>(bank_or_all & ALL), 0, false, 0});
    }
    void refresh() { edge({false, false, false, true, 0, 0, 0, false, 0}); }
    void mode(unsigned value) {
        edge({false, false, false, false, 0, static_cast<std::uint16_t>(value), 0, false, 0});
    }
    void start(unsigned value) {
        now = 100 * US_PS;
        precharge(ALL);
        nop();
        for (int i = 0; i < 2; ++i) {
            refresh();
            nop(6);
        }
        mode(value);
        nop();
    }
    // The words on DQ at the next `count` edges, `latency` edges after a READ's.
    std::vector<std::uint16_t> words(unsigned count, unsigned latency) {
        nop(latency - 1);
        std::vector<std::uint16_t> seen;
        for (unsigned i = 0; i < count; ++i) {
            seen.push_back(chip.dq());
            nop();
        }
        return seen;
    }
    void expect_violation(const char* text) {
        ASSERT_EQ(chip.violations(), 1u);
        EXPECT_THAT(chip.messages().front(), HasSubstr(text));
    }
    void expect_none() { EXPECT_THAT(chip.messages(), IsEmpty()); }
};

constexpr unsigned BURST_2_CL2 = 0x021, BURST_4_CL3 = 0x032, INTERLEAVED_8_CL2 = 0x02b,
                   SINGLE_WRITES = 0x222, ROW_CL3 = 0x037;

TEST_F(Sdram, ReadsABurstBackAfterTheLatencyOfItsMode) {
    start(BURST_4_CL3);
    active(2, 4711);
    nop();
    write(2, 100, 0x1111);
    more(0x2222);
    more(0x3333);
    more(0x4444);
    nop();
    read(2, 100);
    EXPECT_THAT(words(4, 3), ElementsAre(0x1111, 0x2222, 0x3333, 0x4444));
    const auto* at = reinterpret_cast<const std::uint16_t*>(chip.bytes());
    EXPECT_EQ(at[4711 << 12 | 2 << 10 | 101], 0x2222);
    expect_none();
}

TEST_F(Sdram, TakesNoCommandAtTheEdgeAfterCkeLow) {
    start(SINGLE_WRITES);
    active(1, 1);
    nop();
    write(1, 0, 5);
    edge({true, true, true, true, 0, 0, 0, false, 0, false});
    edge({false, true, false, false, 1, 0, 0, true, 6, false});
    edge({false, true, false, false, 1, 0, 0, true, 7, true});
    EXPECT_EQ(chip.violations(), 2u);
    EXPECT_THAT(chip.messages().front(), HasSubstr("WRITE at"));
    EXPECT_THAT(chip.messages().front(), HasSubstr("not taken, since CKE is low"));
    read(1, 0);
    EXPECT_EQ(words(1, 2).front(), 5);
}

TEST_F(Sdram, HoldsABurstWhileCkeIsLow) {
    start(BURST_4_CL3);
    active(2, 7);
    nop();
    write(2, 100, 0x1111);
    edge({true, true, true, true, 0, 0, 0, true, 0x2222, false});
    for (int i = 0; i < 3; ++i) edge({true, true, true, true, 0, 0, 0, true, 0xdead, i == 2});
    more(0x3333);
    more(0x4444);
    nop();
    read(2, 100);
    EXPECT_THAT(words(4, 3), ElementsAre(0x1111, 0x2222, 0x3333, 0x4444));
    expect_none();
}

TEST_F(Sdram, ForgetsNoRowInSelfRefresh) {
    start(SINGLE_WRITES);
    edge({false, false, false, true, 0, 0, 0, false, 0, false});
    now += 1'000'000 * US_PS;
    edge({true, true, true, true, 0, 0, 0, false, 0, true});
    nop(10);
    active(0, 0);
    expect_none();
}

TEST_F(Sdram, WrapsWithinTheBurst) {
    start(BURST_4_CL3);
    active(0, 0);
    nop();
    write(0, 8, 8);
    for (const std::uint16_t word : {9, 10, 11}) more(word);
    nop();
    read(0, 10);
    EXPECT_THAT(words(4, 3), ElementsAre(10, 11, 8, 9));
    expect_none();
}

TEST_F(Sdram, InterleavesWhereTheModeSaysSo) {
    start(INTERLEAVED_8_CL2);
    active(0, 0);
    nop();
    write(0, 0, 0);
    for (const std::uint16_t word : {1, 2, 3, 4, 5, 6, 7}) more(word);
    nop();
    read(0, 3);
    EXPECT_THAT(words(8, 2), ElementsAre(3, 2, 1, 0, 7, 6, 5, 4));
    expect_none();
}

TEST_F(Sdram, WritesSingleWordsWhereTheModeSaysSo) {
    start(SINGLE_WRITES);
    active(1, 1);
    nop();
    write(1, 0, 5);
    write(1, 1, 6);
    nop();
    read(1, 0);
    EXPECT_THAT(words(4, 2), ElementsAre(5, 6, 0, 0));
    expect_none();
}

TEST_F(Sdram, ReadsAWholeRowUntilItIsStopped) {
    start(ROW_CL3);
    active(0, 9);
    nop();
    read(0, 0);
    nop(500);
    EXPECT_TRUE(chip.busy());
    edge({false, true, true, false, 0, 0, 0, false, 0});  // BURST STOP
    nop(4);
    EXPECT_FALSE(chip.busy());
    expect_none();
}

TEST_F(Sdram, MasksBytes) {
    start(BURST_2_CL2);
    active(0, 0);
    nop();
    write(0, 0, 0xaabb, 1);
    more(0xccdd, 2);
    nop();
    read(0, 0);
    EXPECT_THAT(words(2, 2), ElementsAre(0xaa00, 0x00dd));
    read(0, 0, 2);  // two edges before the first word
    EXPECT_THAT(words(2, 2), ElementsAre(0xff00 | 0x00, 0x00dd));
    expect_none();
}

TEST_F(Sdram, ClosesTheRowAfterABurstWithAutoPrecharge) {
    start(BURST_2_CL2);
    active(0, 0);
    nop(3);
    read(0, ALL);
    nop(8);
    active(0, 1);
    expect_none();
}

TEST_F(Sdram, WantsItsInitialisation) {
    now = 100 * US_PS;
    active(0, 0);
    EXPECT_EQ(chip.violations(), 2u);
    EXPECT_THAT(chip.messages().front(),
                HasSubstr("ACTIVE at 100.00 us: no PRECHARGE of all banks after power-up"));
    EXPECT_THAT(chip.messages().back(), HasSubstr("no mode has been set"));
}

TEST_F(Sdram, WantsTheWaitAfterPowerUp) {
    now = 99 * US_PS;
    precharge(ALL);
    expect_violation("the wait after power-up is 100000 ns at least");
}

TEST_F(Sdram, WantsTwoRefreshesBeforeTheMode) {
    now = 100 * US_PS;
    precharge(ALL);
    nop();
    refresh();
    nop(6);
    mode(BURST_2_CL2);
    expect_violation("two refreshes come before it");
}

TEST_F(Sdram, KnowsItsModes) {
    start(0x011);  // CL 1
    expect_violation("0x0011 is not a mode");
}

TEST_F(Sdram, ReportsABankWithoutAnOpenRow) {
    start(BURST_2_CL2);
    read(3, 0);
    expect_violation("bank 3 has no open row");
}

TEST_F(Sdram, ReportsABankWithAnOpenRow) {
    start(BURST_2_CL2);
    active(1, 1);
    nop(10);
    active(1, 2);
    expect_violation("bank 1 has an open row");
}

TEST_F(Sdram, ReportsARefreshOfAnOpenRow) {
    start(BURST_2_CL2);
    active(1, 1);
    nop(10);
    refresh();
    expect_violation("bank 1 has an open row");
}

TEST_F(Sdram, WantsTrcd) {
    start(BURST_2_CL2);
    active(0, 0);
    read(0, 0);
    expect_violation("tRCD is 15 ns at least, not 10.0");
}

TEST_F(Sdram, WantsTras) {
    start(BURST_2_CL2);
    active(0, 0);
    nop(2);
    precharge(0);
    expect_violation("tRAS is 37 ns at least, not 30.0");
}

TEST_F(Sdram, WantsTrp) {
    start(BURST_2_CL2);
    active(0, 0);
    nop(5);
    precharge(0);
    active(0, 0);
    expect_violation("tRP is 15 ns at least, not 10.0");
}

TEST_F(Sdram, WantsTrc) {
    start(BURST_2_CL2);
    active(0, 0);
    nop(3);
    precharge(0);
    nop();
    EXPECT_EQ(chip.violations(), 0u);
    now -= 5'000;  // 55 ns after the first
    active(0, 1);
    EXPECT_GE(chip.violations(), 1u);
    EXPECT_THAT(chip.messages().back(), HasSubstr("tRC is 60 ns at least, not 55.0"));
}

TEST_F(Sdram, WantsTrcAfterARefresh) {
    start(BURST_2_CL2);
    refresh();
    nop(4);
    active(0, 0);
    expect_violation("tRC is 60 ns at least, not 50.0");
}

TEST_F(Sdram, WantsTrrd) {
    start(BURST_2_CL2);
    active(0, 0);
    active(1, 0);
    expect_violation("tRRD is 14 ns at least, not 10.0");
}

TEST_F(Sdram, WantsTwr) {
    start(BURST_2_CL2);
    active(0, 0);
    nop(3);
    write(0, 0, 1);
    more(2);
    precharge(0);
    expect_violation("tWR is 14 ns at least, not 10.0");
}

TEST_F(Sdram, WantsTmrd) {
    start(BURST_2_CL2);
    now -= CLOCK_PS;
    active(0, 0);
    expect_violation("tMRD is 14 ns at least, not 10.0");
}

TEST_F(Sdram, ReportsADataBusThatBothDrive) {
    start(BURST_2_CL2);
    active(0, 0);
    nop();
    read(0, 0);
    nop();
    write(0, 0, 1);  // while the first word is out
    EXPECT_GE(chip.violations(), 1u);
    EXPECT_THAT(chip.messages().front(), HasSubstr("DQ is driven by both sides"));
}

TEST_F(Sdram, ReportsAWriteThatNobodyDrives) {
    start(BURST_2_CL2);
    active(0, 0);
    nop();
    write(0, 0, 1);
    nop();
    expect_violation("nobody drives DQ");
}

TEST_F(Sdram, WantsEachRowRefreshedIn64Milliseconds) {
    start(BURST_2_CL2);
    for (int i = 0; i < 8192; ++i) {
        now = 1000 * US_PS + static_cast<std::uint64_t>(i) * 7 * US_PS;
        refresh();
    }
    now = 65'000 * US_PS - 1;
    active(0, 0);
    EXPECT_THAT(chip.messages(), IsEmpty());
    now = 65'001 * US_PS;
    active(1, 0);
    expect_violation("fewer than 8,192 refreshes in the 64 ms before");
}

}  // namespace
