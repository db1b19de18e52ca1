// keypad_jp1.c - the keypad on JP1 D7-D0 without the scanner: columns as outputs give the row,
// then rows as outputs give the column.  Shows the last key on HEX0, LEDR0 while one is down.
#include "processor.h"
#include "registers.h"

enum { COLUMNS_OUT = 0xF0, ROWS_OUT = 0x0F };

static const uint8_t KEYS[4][4] = {
    {0x1, 0x2, 0x3, 0xA}, {0x4, 0x5, 0x6, 0xB}, {0x7, 0x8, 0x9, 0xC}, {0x0, 0xF, 0xE, 0xD}};

// Which of the four wires is low, from bit 3 down to bit 0; 4: none, or more than one.
static unsigned only_low(uint32_t wires) {
    for (unsigned i = 0; i < 4; ++i)
        if ((wires & 0xF) == (0xFu & ~(8u >> i))) return i;
    return 4;
}

int main(void) {
    for (;;) {
        JP1_DIR = COLUMNS_OUT;
        JP1_DATA = 0;
        const unsigned row = only_low(JP1_DATA);
        JP1_DIR = ROWS_OUT;
        JP1_DATA = 0;
        const unsigned column = only_low(JP1_DATA >> 4);
        if (row < 4 && column < 4) HEX3_0_DATA = DIGITS[KEYS[row][column]];
        LEDR_DATA = row < 4 && column < 4;
    }
}
