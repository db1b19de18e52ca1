// ps2_keyboard.c - resets the keyboard, then shows the last three bytes it sent on HEX5-0.
//
// A keyboard that tests itself after power-on takes no byte: CE, and another try.  LEDR9: the reset
// was answered (FA, AA); LEDR8-1: keys released.
#include "processor.h"
#include "registers.h"

enum { RESET = 0xFF, ACKNOWLEDGE = 0xFA, PASSED = 0xAA, BREAK = 0xF0 };

static uint32_t next(void) {
    uint32_t data;
    do data = PS2_0_DATA;
    while ((data & 0x8000) == 0);
    return data & 0xFF;
}

static void reset(void) {
    do {
        PS2_0_CONTROL = 0;
        PS2_0_DATA = RESET;
        while ((PS2_0_CONTROL & 0x400) == 0 && (PS2_0_DATA & 0x80FF) != (0x8000 | ACKNOWLEDGE)) {
        }
    } while (PS2_0_CONTROL & 0x400);
    while (next() != PASSED) {
    }
}

static uint32_t two_digits(uint32_t byte) {
    return (uint32_t)DIGITS[byte >> 4 & 15] << 8 | DIGITS[byte & 15];
}

int main(void) {
    uint32_t last = 0, keys = 0;
    reset();
    LEDR_DATA = 0x200;
    for (;;) {
        const uint32_t byte = next();
        if ((last & 0xFF) == BREAK) ++keys;
        last = last << 8 | byte;
        HEX3_0_DATA = two_digits(last >> 8) << 16 | two_digits(last);
        HEX5_4_DATA = two_digits(last >> 16);
        LEDR_DATA = 0x200 | keys << 1;
    }
}
