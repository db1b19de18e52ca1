// mouse_draw.c - a mouse in the first PS/2 port, by its interrupt (ID 79): the left button draws, the
// right one clears the screen.  HEX5-3 is where it is from the left, HEX2-0 from the top; LEDR2-0 are
// the buttons.
#include "memory.h"
#include "processor.h"
#include "registers.h"

enum { WIDTH = 320, HEIGHT = 240 };
enum { RESET = 0xFF, ACKNOWLEDGE = 0xFA, REPORT = 0xF4 };
enum { LEFT = 1, RIGHT = 2, FIRST = 8, X_SIGN = 0x10, Y_SIGN = 0x20 };

static int x = 160, y = 120;
static uint32_t buttons;

static void plot(int to_x, int to_y, uint16_t colour) {
    *(volatile uint16_t*)(ONCHIP + ((uint32_t)to_y << 10) + ((uint32_t)to_x << 1)) = colour;
}

static void clear(void) {
    for (int row = 0; row < HEIGHT; ++row)
        for (int column = 0; column < WIDTH; ++column) plot(column, row, 0);
}

static int within(int place, int most) { return place < 0 ? 0 : place > most ? most : place; }

static uint32_t three_digits(int number) {
    return (uint32_t)DIGITS[number / 100] << 16 | (uint32_t)DIGITS[number / 10 % 10] << 8 |
           DIGITS[number % 10];
}

static void show(void) {
    HEX5_4_DATA = three_digits(x) >> 8;
    HEX3_0_DATA = three_digits(x) << 24 | three_digits(y);
    LEDR_DATA = buttons;
}

static void packet(const uint8_t* bytes) {
    const int from_x = x, from_y = y;
    x = within(x + bytes[1] - (bytes[0] & X_SIGN ? 256 : 0), WIDTH - 1);
    y = within(y - bytes[2] + (bytes[0] & Y_SIGN ? 256 : 0), HEIGHT - 1);
    buttons = bytes[0] & 7;
    show();
    if (buttons & RIGHT) clear();
    if (!(buttons & LEFT)) return;
    const int across = x - from_x, down = y - from_y;
    for (int i = 0; i <= 64; ++i) plot(from_x + across * i / 64, from_y + down * i / 64, 0xFFFF);
}

INTERRUPT_HANDLER on_irq(void) {
    static uint8_t bytes[3];
    static unsigned count;
    const uint32_t id = interrupt_begin();
    for (uint32_t data; id == PS2_INTERRUPT && (data = PS2_0_DATA) & 0x8000;) {
        if (count == 0 && !(data & FIRST)) continue;  // not the beginning of a packet
        bytes[count++] = (uint8_t)data;
        if (count == 3) {
            count = 0;
            packet(bytes);
        }
    }
    interrupt_end(id);
}

static uint32_t next(void) {
    uint32_t data;
    do data = PS2_0_DATA;
    while ((data & 0x8000) == 0);
    return data & 0xFF;
}

static void command(uint32_t byte) {
    do {
        PS2_0_CONTROL = 0;
        PS2_0_DATA = byte;
        while ((PS2_0_CONTROL & 0x400) == 0 && (PS2_0_DATA & 0x80FF) != (0x8000 | ACKNOWLEDGE)) {
        }
    } while (PS2_0_CONTROL & 0x400);
}

int main(void) {
    clear();
    command(RESET);
    while (next() != 0xAA) {
    }
    next();  // 00, a mouse
    command(REPORT);
    show();
    PS2_0_CONTROL = 1;
    interrupt_on(PS2_INTERRUPT);
    interrupts_enable();
    for (;;) __asm volatile("wfi");
}
