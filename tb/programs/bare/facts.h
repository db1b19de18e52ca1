// facts.h - checks of what programs may rely on, one numbered fact after the other.
//
// All LEDs: every fact holds.  Otherwise the LEDs show the number of the first one that does not.
#pragma once

#include "processor.h"
#include "registers.h"

enum { ALL_LEDS = 0x3FF };

static inline void fact(uint32_t number, int holds) {
    if (holds) return;
    LEDR_DATA = number;
    for (;;) {
    }
}

static inline int about(uint32_t value, uint32_t expected, uint32_t off) {
    return value + off >= expected && value <= expected + off;
}

// By polling the A9's private timer at 200 MHz, so up to 1 us longer.
static inline void wait_us(uint32_t us) {
    A9_TIMER_CONTROL = 0, A9_TIMER_STATUS = 1;
    A9_TIMER_LOAD = 200 * us, A9_TIMER_CONTROL = 1;
    while (A9_TIMER_STATUS == 0) {
    }
    A9_TIMER_STATUS = 1;
}
