// a9_timer.c - one LED walks, a step every 50 ms of the A9's private timer, which is polled.
#include "processor.h"
#include "registers.h"

enum { STEP = 200000000 / 20, ENABLE = 1, AUTO = 2 };

int main(void) {
    uint32_t led = 1;
    A9_TIMER_LOAD = STEP;
    A9_TIMER_CONTROL = AUTO | ENABLE;
    for (;;) {
        LEDR_DATA = led;
        while (A9_TIMER_STATUS == 0) {
        }
        A9_TIMER_STATUS = A9_TIMER_STATUS;
        led = led == 1u << 9 ? 1 : led << 1;
    }
}
