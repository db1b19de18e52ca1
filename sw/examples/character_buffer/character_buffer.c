// character_buffer.c - text over a blue box; KEY0 clears the text, not the box.
//
// The text: a line centred in the box, all printable characters, and the four corners.
#include "memory.h"
#include "registers.h"

enum { COLUMNS = 80, ROWS = 60 };

static void text(int x, int y, const char* letters) {
    volatile char* at = (volatile char*)(CHARACTERS + (y << 7) + x);
    while (*letters) *at++ = *letters++;
}

static void box(int x0, int y0, int x1, int y1, uint16_t colour) {
    for (int y = y0; y <= y1; ++y)
        for (int x = x0; x <= x1; ++x)
            *(volatile uint16_t*)(ONCHIP + (y << 10) + (x << 1)) = colour;
}

int main(void) {
    char all[] = "?";
    if (TEXT_RESOLUTION != (ROWS << 16 | COLUMNS)) return 1;
    box(100, 108, 219, 131, 0x187F);
    text(COLUMNS / 2 - 8, ROWS / 2, "Text over a box.");
    for (char c = ' '; c <= '~'; ++c) {
        all[0] = c;
        text(8 + c % 32 * 2, 40 + c / 32 * 2, all);
    }
    text(0, 0, "(");
    text(COLUMNS - 1, 0, ")");
    text(0, ROWS - 1, "[");
    text(COLUMNS - 1, ROWS - 1, "]");
    LEDR_DATA = 1;
    while ((KEY_EDGE & 1) == 0) {
    }
    TEXT_BUFFER = 1 << 16;
    while (TEXT_BUFFER & 1 << 16) {
    }
    LEDR_DATA = 3;
    for (;;) {
    }
}
