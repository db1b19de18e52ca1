// The A9's private timer, watchdog and global timer, at their registers and interrupts.
#include "tb/sim/hps_bench.h"

namespace {

constexpr std::uint32_t LOAD = 0xFFFEC600, COUNTER = LOAD + 4, CONTROL = LOAD + 8,
                        STATUS = LOAD + 0xC;
constexpr std::uint32_t WATCHDOG = LOAD + 0x20;
constexpr std::uint32_t E = 1, A = 2, I = 4, WATCHDOG_MODE = 8;

class PrivateTimer : public tb::HpsBench {
protected:
    void start(std::uint32_t load, std::uint32_t control) {
        write(LOAD, load);
        write(CONTROL, control);
    }
};

TEST_F(PrivateTimer, CountsDownAt200MhzByThePrescalerPlusOne) {
    for (const std::uint32_t prescaler : {0u, 9u, 255u}) {
        write(CONTROL, 0);
        start(1'000'000, E | prescaler << 8);
        wait_ms(1);
        EXPECT_EQ(read(COUNTER), 1'000'000 - 200'000 / (prescaler + 1));
    }
}

TEST_F(PrivateTimer, SetsItsStatusAtZeroAndStaysThere) {
    start(199, E);
    wait_ns(199 * 5 - 20);
    EXPECT_EQ(read(STATUS), 0u);
    wait_ns(20);
    EXPECT_EQ(read(STATUS), 1u);
    wait_ms(1);
    EXPECT_EQ(read(COUNTER), 0u);
}

TEST_F(PrivateTimer, ReloadsWithAPeriodOfLoadPlusOne) {
    start(199, E | A);
    wait_ns(200 * 5 * 1000);  // 1000 periods
    EXPECT_NEAR(read(COUNTER), 197, 2);
}

TEST_F(PrivateTimer, SetsItsStatusAgainInTheNextPeriod) {
    start(199, E | A);
    wait_ns(1100);
    write(STATUS, 1);
    EXPECT_EQ(read(STATUS), 0u);
    wait_ns(1000);
    EXPECT_EQ(read(STATUS), 1u);
}

TEST_F(PrivateTimer, KeepsItsStatusWhenItIsStopped) {
    start(10, E);
    wait_ns(1000);
    write(CONTROL, 0);
    EXPECT_EQ(read(STATUS), 1u);
}

TEST_F(PrivateTimer, StandsStillWhileItIsOff) {
    start(1000, E);
    wait_ns(1000);
    write(CONTROL, 0);
    const std::uint32_t count = read(COUNTER);
    wait_ms(1);
    EXPECT_EQ(read(COUNTER), count);
    write(CONTROL, E);
    wait_ns(50);
    EXPECT_NEAR(read(COUNTER), count - 10, 2);
}

TEST_F(PrivateTimer, InterruptsAtItsExpiryAsId29) {
    take(29);
    start(199'999, E | I);
    wait_ns(999'000);
    EXPECT_FALSE(board.irq);
    wait_ns(1'100);
    EXPECT_TRUE(board.irq);
    EXPECT_EQ(acknowledge(), 29u);
}

TEST_F(PrivateTimer, InterruptsEveryPeriodIfItsStatusIsCleared) {
    take(29);
    start(199'999, E | A | I);
    wait_ns(1000);
    for (int period = 0; period < 5; ++period) {
        wait_ms(1);
        EXPECT_EQ(acknowledge(), 29u) << period;
        write(STATUS, 1);
        end(29);
        EXPECT_EQ(acknowledge(), 1023u) << period;
    }
}

TEST_F(PrivateTimer, IsSilentWithoutItsInterruptBit) {
    take(29);
    start(100, E | A);
    wait_ms(1);
    EXPECT_FALSE(board.irq);
}

TEST_F(PrivateTimer, TakesANewCountWhileItRuns) {
    start(1000, E);
    wait_ns(100);
    write(COUNTER, 5000);
    wait_ns(500);
    EXPECT_NEAR(read(COUNTER), 4900, 3);
    EXPECT_EQ(read(LOAD), 1000u);
}

TEST_F(PrivateTimer, AsAWatchdogAsksForAReset) {
    write(WATCHDOG, 200'000);
    write(WATCHDOG + 8, E | WATCHDOG_MODE);
    wait_ms(0.9);
    EXPECT_EQ(board.resets, 0u);
    wait_ms(0.2);
    EXPECT_EQ(board.resets, 1u);
    EXPECT_EQ(read(WATCHDOG + 0x10), 1u) << "reset status";
    wait_ms(5);
    EXPECT_EQ(board.resets, 1u);
}

TEST_F(PrivateTimer, AsAWatchdogIsFedByWritingItsLoad) {
    write(WATCHDOG, 200'000);
    write(WATCHDOG + 8, E | WATCHDOG_MODE);
    for (int i = 0; i < 5; ++i) {
        wait_ms(0.9);
        write(WATCHDOG, 200'000);
    }
    EXPECT_EQ(board.resets, 0u);
}

TEST_F(PrivateTimer, LeavesTheWatchdogModeByTwoKeysOnly) {
    write(WATCHDOG, 200'000);
    write(WATCHDOG + 8, E | WATCHDOG_MODE);
    write(WATCHDOG + 8, 0);
    EXPECT_TRUE(read(WATCHDOG + 8) & WATCHDOG_MODE);
    write(WATCHDOG + 0x14, 0x12345678);
    write(WATCHDOG + 0x14, 0x87654321);
    EXPECT_FALSE(read(WATCHDOG + 8) & WATCHDOG_MODE);
    wait_ms(5);
    EXPECT_EQ(board.resets, 0u);
}

TEST_F(PrivateTimer, AsASecondTimerInterruptsAsId30) {
    take(30);
    write(WATCHDOG, 1000);
    write(WATCHDOG + 8, E | I);
    wait_ns(5100);
    EXPECT_EQ(acknowledge(), 30u);
}

// ---- The global timer's comparator --------------------------------------------------------------

constexpr std::uint32_t GLOBAL = 0xFFFEC200;

TEST_F(PrivateTimer, LeavesId27ToTheGlobalTimersComparator) {
    take(27);
    write(GLOBAL + 0x10, 200'000);
    write(GLOBAL + 0x08, 1 | 2 | 4);
    wait_ms(0.99);
    EXPECT_FALSE(board.irq);
    wait_ms(0.02);
    EXPECT_EQ(acknowledge(), 27u);
    EXPECT_EQ(read(GLOBAL + 0x0C), 1u);
}

TEST_F(PrivateTimer, HasAGlobalNeighbourThatInterruptsAgainByItsIncrement) {
    take(27);
    write(GLOBAL + 0x10, 200'000);
    write(GLOBAL + 0x18, 200'000);
    write(GLOBAL + 0x08, 1 | 2 | 4 | 8);
    wait_ms(0.01);
    for (int i = 0; i < 5; ++i) {
        wait_ms(1);
        EXPECT_EQ(acknowledge(), 27u) << i;
        write(GLOBAL + 0x0C, 1);
        end(27);
    }
}

}  // namespace
