// What start-up code and Intel's HWLib touch before anything else: clocks, watchdogs, resets.
#include "tb/sim/hps_bench.h"

namespace {

// ---- Clocks -------------------------------------------------------------------------------------

// Frequencies as the Cyclone V HPS TRM computes them from the registers.
class Clocks : public tb::HpsBench {
protected:
    static constexpr std::uint32_t BASE = 0xFFD04000, MAIN = BASE + 0x40, PERIPHERAL = BASE + 0x80,
                                   SDRAM = BASE + 0xC0, MISC = BASE + 0xE0;
    unsigned vco_mhz(std::uint32_t pll) {
        const std::uint32_t vco = read(pll);
        return 25 * ((vco >> 3 & 0x1FFF) + 1) / ((vco >> 16 & 0x3F) + 1);
    }
    unsigned over(std::uint32_t counter) { return (read(counter) & 0x1FF) + 1; }
};

TEST_F(Clocks, AreThoseOfTheBoardsPreloader) {
    EXPECT_EQ(vco_mhz(MAIN) / over(MISC) / over(MAIN + 0x08), 800u) << "the processor";
    const unsigned base = vco_mhz(PERIPHERAL) / over(PERIPHERAL + 0x18);
    EXPECT_EQ(read(MAIN + 0x30), 3u) << "L4_MP and L4_SP are of the peripheral PLL";
    EXPECT_EQ(base >> (read(MAIN + 0x24) >> 7 & 7), 100u) << "L4_SP";
    EXPECT_EQ(base >> (read(MAIN + 0x24) >> 4 & 7), 100u) << "L4_MP";
    EXPECT_EQ(vco_mhz(SDRAM) / over(SDRAM + 0x08), 400u) << "the DDR3";
}

TEST_F(Clocks, AreLockedAndOnAndNotBypassed) {
    EXPECT_EQ(read(BASE + 0x08) & 0x1C0, 0x1C0u);
    EXPECT_EQ(read(BASE + 0x04), 0u);
    EXPECT_EQ(read(BASE + 0x14), 0u) << "not busy";
    EXPECT_EQ(read(MAIN + 0x20), 0x3FFu);
    EXPECT_EQ(read(PERIPHERAL + 0x20), 0xFFFu);
    EXPECT_EQ(read(SDRAM + 0x18), 0xFu);
}

TEST_F(Clocks, KeepWhatIsWrittenAndReportOnceThatNothingFollows) {
    write(MAIN + 0x14, 7);
    EXPECT_EQ(read(MAIN + 0x14), 7u);
    write(PERIPHERAL + 0x18, 0xFFFFFFFF);
    EXPECT_EQ(read(PERIPHERAL + 0x18), 0x1FFu) << "nine bits";
    ASSERT_EQ(board.said.size(), 1u);
    EXPECT_NE(board.said[0].find("the clocks stay"), std::string::npos);
}

TEST_F(Clocks, ReportNothingWhileTheirSettingsAreTheSame) {
    write(MAIN + 0x24, read(MAIN + 0x24));
    write(BASE + 0x0C, 1);
    EXPECT_TRUE(board.said.empty());
}

// ---- Watchdogs ----------------------------------------------------------------------------------

class L4Watchdog : public tb::HpsBench {
protected:
    static constexpr std::uint32_t W0 = 0xFFD02000, W1 = 0xFFD03000, STAT = 0xFFD05000;
    static constexpr std::uint32_t ENABLE = 1, INTERRUPT = 2, KICK = 0x76;
    static constexpr double SHORTEST_MS = 65536 / 25e3;
    void start(std::uint32_t watchdog, std::uint32_t range, std::uint32_t control) {
        write(watchdog + 0x04, range);
        write(watchdog, control);
    }
};

TEST_F(L4Watchdog, IsOffUntilTheProgramStartsIt) {
    write(W0 + 0x0C, KICK);
    EXPECT_EQ(read(W0) & ENABLE, 0u);
    wait_ms(100'000);
    EXPECT_EQ(board.resets, 0u);
}

TEST_F(L4Watchdog, ResetsTheBoardAtItsEnd) {
    start(W1, 0x55, ENABLE);
    wait_ms(32 * SHORTEST_MS - 0.01);
    EXPECT_EQ(board.resets, 0u);
    wait_ms(0.02);
    EXPECT_EQ(board.resets, 1u);
    EXPECT_EQ(read(STAT), 1u << 15);
    EXPECT_EQ(read(W1) & ENABLE, 0u) << "it is reset, too";
}

TEST_F(L4Watchdog, StartsAnewWithEachKick) {
    start(W0, 0x00, ENABLE);
    for (int i = 0; i < 5; ++i) {
        wait_ms(0.9 * SHORTEST_MS);
        write(W0 + 0x0C, KICK);
        EXPECT_NEAR(read(W0 + 0x08), 0xFFFF, 1);
    }
    write(W0 + 0x0C, 0x75);
    wait_ms(1.1 * SHORTEST_MS);
    EXPECT_EQ(board.resets, 1u);
    EXPECT_EQ(read(STAT), 1u << 14);
}

TEST_F(L4Watchdog, CountsFromItsInitialRangeAtFirst) {
    start(W0, 0x10, ENABLE);
    EXPECT_NEAR(read(W0 + 0x08), 0x1FFFF, 1);
    write(W0 + 0x0C, KICK);
    EXPECT_NEAR(read(W0 + 0x08), 0xFFFF, 1);
}

TEST_F(L4Watchdog, InterruptsFirstWhenAskedTo) {
    take(203);
    start(W0, 0x00, ENABLE | INTERRUPT);
    wait_ms(1.01 * SHORTEST_MS);
    EXPECT_TRUE(board.irq);
    EXPECT_EQ(read(W0 + 0x10), 1u);
    EXPECT_EQ(acknowledge(), 203u);
    read(W0 + 0x14);
    EXPECT_EQ(read(W0 + 0x10), 0u);
    end(203);
    wait_ms(SHORTEST_MS);
    EXPECT_TRUE(board.irq) << "and again, as it was cleared";
    EXPECT_EQ(board.resets, 0u);
    wait_ms(SHORTEST_MS);
    EXPECT_EQ(board.resets, 1u) << "this time it was not";
}

TEST_F(L4Watchdog, CannotBeSwitchedOffButByTheResetManager) {
    start(W0, 0x00, ENABLE);
    write(W0, 0);
    EXPECT_EQ(read(W0) & ENABLE, ENABLE);
    write(0xFFD05014, 1 << 6);
    write(0xFFD05014, 0);
    EXPECT_EQ(read(W0) & ENABLE, 0u);
    wait_ms(3 * SHORTEST_MS);
    EXPECT_EQ(board.resets, 0u);
}

TEST_F(L4Watchdog, IsQuietAfterAnotherReset) {
    start(W0, 0x00, ENABLE);
    write(0xFFD05004, 2);
    wait_ms(3 * SHORTEST_MS);
    EXPECT_EQ(board.resets, 1u);
}

// ---- The second processor -----------------------------------------------------------------------

TEST_F(Clocks, OfTheSecondProcessorAreReportedOnceAsMissing) {
    constexpr std::uint32_t MPUMODRST = 0xFFD05010;
    EXPECT_EQ(read(MPUMODRST), 2u) << "in reset";
    for (const std::uint32_t value : {0u, 2u, 0u}) write(MPUMODRST, value);
    ASSERT_EQ(board.said.size(), 1u);
    EXPECT_NE(board.said[0].find("second processor"), std::string::npos);
}

using L2Cache = tb::HpsBench;

TEST_F(L2Cache, HasEightWaysOf64Kilobytes) {
    constexpr std::uint32_t L2 = 0xFFFEF000;
    EXPECT_EQ(read(L2), 0x410030C9u);
    const std::uint32_t type = read(L2 + 4), auxiliary = read(L2 + 0x104);
    const auto way = [](std::uint32_t field) { return 8u << 10 << (field & 7); };
    EXPECT_EQ(way(type >> 20), 64u << 10);
    EXPECT_EQ(way(type >> 8), 64u << 10);
    EXPECT_EQ(way(auxiliary >> 17), 64u << 10);
    EXPECT_EQ(auxiliary >> 16 & 1, 0u) << "8 ways";
    write(L2 + 4, 0);
    EXPECT_EQ(read(L2 + 4), type);
}

}  // namespace
