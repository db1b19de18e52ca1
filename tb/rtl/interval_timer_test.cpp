// interval_timer_test.cpp - what tb/formal/interval_timer_formal.v leaves open: writes of bytes,
// and periods of less than a clock.
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
                        START = regmap::TIMER0_CONTROL_START_MASK;

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
};

TEST_F(IntervalTimer, ABytesWriteKeepsTheOtherBytesOfThePeriod) {
    period(0x89AB'CDEF);
    write(PERIOD_LOW, 0x11, 0b0001);
    EXPECT_EQ(read(PERIOD_LOW), 0xCD11u);
    write(PERIOD_HIGH, 0x2200, 0b0010);
    EXPECT_EQ(read(PERIOD_HIGH), 0x22ABu);
    EXPECT_EQ(counter(), 0x22AB'CD11u);
}

TEST_F(IntervalTimer, HasNothingBehindItsRegisters) {
    write(CONTROL, CONT | ITO);
    for (const std::uint32_t place : {SNAP_HIGH + 4, SNAP_HIGH + 8}) {
        write(place, 0xffff'ffff);
        EXPECT_EQ(read(place), 0u);
    }
    EXPECT_EQ(read(CONTROL), CONT | ITO);
    EXPECT_EQ(read(PERIOD_LOW) | read(PERIOD_HIGH) << 16, 12'499'999u);
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
