// arrows_box.c - the arrow keys move a box over the screen, as long as they are held; Space paints it
// in the next colour.  HEX5-3 is where it is from the left, HEX2-0 from the top.
#include "memory.h"
#include "processor.h"
#include "registers.h"

enum { WIDTH = 320, HEIGHT = 240, SIZE = 16, STEP = 8 };
enum {
    EXTENDED = 0xE0,
    BREAK = 0xF0,
    UP = 0x75,
    LEFT = 0x6B,
    DOWN = 0x72,
    RIGHT = 0x74,
    SPACE = 0x29
};

static const uint16_t COLOURS[] = {0xF800, 0x07E0, 0x001F};

static void fill(int left, int top, int width, int height, uint16_t colour) {
    for (int y = top; y < top + height; ++y)
        for (int x = left; x < left + width; ++x)
            *(volatile uint16_t*)(ONCHIP + ((uint32_t)y << 10) + ((uint32_t)x << 1)) = colour;
}

static uint32_t three_digits(int number) {
    return (uint32_t)DIGITS[number / 100] << 16 | (uint32_t)DIGITS[number / 10 % 10] << 8 |
           DIGITS[number % 10];
}

static void show(int x, int y) {
    HEX5_4_DATA = three_digits(x) >> 8;
    HEX3_0_DATA = three_digits(x) << 24 | three_digits(y);
}

static int within(int place, int most) { return place < 0 ? 0 : place > most ? most : place; }

int main(void) {
    int x = 152, y = 112;
    unsigned colour = 0;
    int extended = 0, released = 0;
    fill(0, 0, WIDTH, HEIGHT, 0);
    for (;;) {
        fill(x, y, SIZE, SIZE, COLOURS[colour % 3]);
        show(x, y);
        uint32_t data;
        do data = PS2_0_DATA;
        while ((data & 0x8000) == 0);
        const uint32_t byte = data & 0xFF;
        if (byte == EXTENDED) {
            extended = 1;
        } else if (byte == BREAK) {
            released = 1;
        } else {
            if (!released && extended) {
                fill(x, y, SIZE, SIZE, 0);
                x = within(x + (byte == RIGHT ? STEP : byte == LEFT ? -STEP : 0), WIDTH - SIZE);
                y = within(y + (byte == DOWN ? STEP : byte == UP ? -STEP : 0), HEIGHT - SIZE);
            }
            if (!released && !extended && byte == SPACE) ++colour;
            extended = released = 0;
        }
    }
}
