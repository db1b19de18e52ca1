// hps_timer.c - counts tenths of a second on HEX1-0 by HPS timer 0, polled; built for soft float.
#include "processor.h"
#include "registers.h"

#define TIMER_LOAD REGISTER(0xFFC08000)
#define TIMER_CONTROL REGISTER(0xFFC08008)
#define TIMER_END REGISTER(0xFFC0800C)
#define TIMER_STATUS REGISTER(0xFFC08010)

enum { CLOCK_HZ = 100000000, ENABLE = 1, USER_MODE = 2 };

static volatile float seconds = 0.1f;

int main(void) {
    TIMER_CONTROL = 0;
    TIMER_LOAD = (uint32_t)(CLOCK_HZ * seconds);
    TIMER_CONTROL = USER_MODE | ENABLE;
    for (uint32_t count = 0;; ++count) {
        HEX3_0_DATA = DIGITS[count % 10] | (uint32_t)DIGITS[count / 10 % 10] << 8;
        while (TIMER_STATUS == 0) {
        }
        (void)TIMER_END;  // reading clears
    }
}
