// interval_timers.c - the FPGA's two timers: the first polled, the second by interrupt (ID 74).
//
// LEDR counts periods of the first (a quarter of its default 125 ms), HEX0 of the second (10 ms).
#include "processor.h"
#include "registers.h"

#define TIMER0 0xFF202000
#define TIMER1 0xFF202020
#define STATUS(timer) REGISTER((timer) + 0x00)
#define CONTROL(timer) REGISTER((timer) + 0x04)
#define PERIOD_LOW(timer) REGISTER((timer) + 0x08)
#define PERIOD_HIGH(timer) REGISTER((timer) + 0x0C)

enum { ITO = 1, CONT = 2, START = 4, TEN_MS = 1000000 };

static volatile uint32_t tens;

INTERRUPT_HANDLER on_irq(void) {
    const uint32_t id = interrupt_begin();
    if (id == TIMER1_INTERRUPT) {
        STATUS(TIMER1) = 0;
        HEX3_0_DATA = DIGITS[++tens % 10];
    }
    interrupt_end(id);
}

int main(void) {
    const uint32_t period = (PERIOD_HIGH(TIMER0) << 16 | PERIOD_LOW(TIMER0)) / 4;
    PERIOD_LOW(TIMER0) = period & 0xFFFF;
    PERIOD_HIGH(TIMER0) = period >> 16;
    PERIOD_LOW(TIMER1) = (TEN_MS - 1) & 0xFFFF;
    PERIOD_HIGH(TIMER1) = (TEN_MS - 1) >> 16;
    interrupt_on(TIMER1_INTERRUPT);
    CONTROL(TIMER0) = START | CONT;
    CONTROL(TIMER1) = START | CONT | ITO;
    interrupts_enable();
    for (uint32_t quarters = 0;; ++quarters) {
        LEDR_DATA = quarters;
        while ((STATUS(TIMER0) & 1) == 0) {
        }
        STATUS(TIMER0) = 0;
    }
}
