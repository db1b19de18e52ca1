// interval_timer_test.cpp - the DE1-SoC Computer's interval timer: 100 MHz by a clock of 25 MHz.
#include <gtest/gtest.h>

#include "Vinterval_timer.h"
#include "regmap.h"
#include "tb/support/register_bus.h"

namespace {

constexpr std::uint32_t STATUS = regmap::TIMER0_STATUS, CONTROL = regmap::TIMER0_CONTROL,
                        PERIOD_LOW = regmap::TIMER0_PERIOD_LOW,
                        PERIOD_HIGH = regmap::TIMER0_PERIOD_HIGH,
                        SNAP_LOW = regmap::TIMER0_SNAP_LOW, SNAP_HIGH = regmap::TIMER0_SNAP_HIGH;
constexpr std::uint32_t TO = regmap::TIMER0_STATUS_TO_MASK, RUN = regmap::TIMER0_STATUS_RUN_MASK,
                        ITO = regmap::TIMER0_CONTROL_ITO_MASK,
                        CONT = regmap::TIMER0_CONTROL_CONT_MASK,
                        START = regmap::TIMER0_CONTROL_START_MASK,
                        STOP = regmap::TIMER0_CONTROL_STOP_MASK;

class IntervalTimer : public tb::RegisterBus<Vinterval_timer> {
protected:
    void SetUp() override { reset(); }

    void period(std::uint32_t ticks_less_one) {
        write(PERIOD_LOW, ticks_less_one & 0xffff);
        write(PERIOD_HIGH, ticks_less_one >> 16);
    }
    std::uint32_t counter() {
        write(SNAP_LOW, 0);
        return read(SNAP_LOW) | read(SNAP_HIGH) << 16;
    }
    // Clocks until the interrupt line rises.
    unsigned until_irq(unsigned at_most) {
        unsigned count = 0;
        while (!dut.irq_o && count < at_most) {
            clock();
            ++count;
        }
        return count;
    }
};

TEST_F(IntervalTimer, StandsAt125MillisecondsAfterReset) {
    EXPECT_EQ(read(PERIOD_LOW) | read(PERIOD_HIGH) << 16, 12'500'000u - 1);
    EXPECT_EQ(counter(), 12'500'000u - 1);
    EXPECT_EQ(read(STATUS), 0u);
    clock(10);
    EXPECT_EQ(counter(), 12'500'000u - 1);
}

TEST_F(IntervalTimer, CountsFourTicksAClock) {
    period(1'000'000);
    write(CONTROL, START);
    EXPECT_EQ(read(STATUS), RUN);
    const std::uint32_t before = counter();
    const std::uint64_t then = clocks;
    clock(1000);
    const std::uint32_t after = counter();
    EXPECT_EQ(before - after, 4 * (clocks - then));
}

TEST_F(IntervalTimer, StopsAfterAPeriodWithoutContinuousMode) {
    period(99);
    write(CONTROL, START);
    clock(30);
    EXPECT_EQ(read(STATUS), TO);
    EXPECT_EQ(counter(), 99u);
}

TEST_F(IntervalTimer, KeepsItsRateWithPeriodsThatAreNoWholeClocks) {
    constexpr unsigned TICKS = 103, PERIODS = 400;
    period(TICKS - 1);
    write(CONTROL, START | CONT | ITO);
    until_irq(100);
    const std::uint64_t first = clocks;
    for (unsigned i = 0; i < PERIODS; ++i) {
        write(STATUS, 0);
        until_irq(100);
    }
    EXPECT_NEAR(static_cast<double>(clocks - first), TICKS * PERIODS / 4.0, 1);
}

TEST_F(IntervalTimer, InterruptsOnlyIfAskedAndUntilStatusIsWritten) {
    period(99);
    write(CONTROL, START | CONT);
    clock(30);
    EXPECT_EQ(read(STATUS), TO | RUN);
    EXPECT_EQ(dut.irq_o, 0);
    write(CONTROL, CONT | ITO);
    EXPECT_EQ(dut.irq_o, 1);
    write(STATUS, TO);
    EXPECT_EQ(dut.irq_o, 0);
}

TEST_F(IntervalTimer, StopHoldsTheCounterAndStartGoesOnFromThere) {
    period(100'000);
    write(CONTROL, START | CONT);
    clock(100);
    write(CONTROL, STOP | CONT);
    const std::uint32_t held = counter();
    EXPECT_LT(held, 99'700u);
    clock(100);
    EXPECT_EQ(counter(), held);
    write(CONTROL, START | CONT);
    EXPECT_LT(counter(), held);
    EXPECT_GT(counter(), held - 100);
}

TEST_F(IntervalTimer, AWrittenPeriodStopsAndReloads) {
    write(CONTROL, START | CONT);
    clock(10);
    write(PERIOD_LOW, 0x1234);
    EXPECT_EQ(read(STATUS), 0u);
    EXPECT_EQ(counter(), 0x00BE1234u);
}

TEST_F(IntervalTimer, ABytesWriteKeepsTheOtherBytesOfThePeriod) {
    period(0x89AB'CDEF);
    write(PERIOD_LOW, 0x11, 0b0001);
    EXPECT_EQ(read(PERIOD_LOW), 0xCD11u);
    write(PERIOD_HIGH, 0x2200, 0b0010);
    EXPECT_EQ(read(PERIOD_HIGH), 0x22ABu);
    EXPECT_EQ(counter(), 0x22AB'CD11u);
}

TEST_F(IntervalTimer, ControlReadsAllThatWasWrittenStartAndStopToo) {
    write(CONTROL, START | STOP | CONT | ITO);
    EXPECT_EQ(read(CONTROL), START | STOP | CONT | ITO);
    EXPECT_EQ(read(STATUS), RUN);
    write(CONTROL, STOP);
    EXPECT_EQ(read(CONTROL), STOP);
    EXPECT_EQ(read(STATUS), 0u);
}

TEST_F(IntervalTimer, ReadsZeroAfterItsRegisters) {
    write(0x18, 0xffff);
    EXPECT_EQ(read(0x18), 0u);
    EXPECT_EQ(read(0x1C), 0u);
}

TEST_F(IntervalTimer, EndsOnceAClockWhereThePeriodIsShorter) {
    period(1);
    write(CONTROL, START | CONT);
    clock(2);
    write(STATUS, 0);
    clock(2);
    EXPECT_EQ(read(STATUS), TO | RUN);
}

TEST_F(IntervalTimer, APeriodOfZeroEndsOnce) {
    write(PERIOD_HIGH, 0);
    EXPECT_EQ(read(STATUS), 0u);
    write(PERIOD_LOW, 0);
    EXPECT_EQ(read(STATUS), TO);
    write(STATUS, 0);
    write(CONTROL, START | CONT | ITO);
    clock(10);
    EXPECT_EQ(read(STATUS), RUN);
    EXPECT_EQ(counter(), 0u);
    write(CONTROL, START);
    clock(2);
    EXPECT_EQ(read(STATUS), 0u);
}

}  // namespace
