// screen.h - two pictures of 320 x 240 pixels that take turns on the monitor, and text over them
//
// One picture is shown while the program draws the other one, so nobody sees a picture that is half
// drawn.  screen_show() changes them over; that happens 60 times per second, at the end of a frame.
#pragma once

#include "memory.h"
#include "registers.h"

enum { WIDTH = 320, HEIGHT = 240, COLUMNS = 80, LINES = 60 };
enum { PICTURE_1 = ONCHIP, PICTURE_2 = PICTURES };

// A colour from 0 to 255 of red, green and blue; the board keeps 5, 6 and 5 bits of them.
static inline uint16_t rgb(unsigned red, unsigned green, unsigned blue) {
    return (uint16_t)(red >> 3 << 11 | green >> 2 << 5 | blue >> 3);
}

static uint32_t screen_picture;  // address of the picture that is not shown

// A pixel of that picture.  (0, 0) is the upper left corner; outside of it nothing happens.
static inline void screen_plot(int x, int y, uint16_t colour) {
    if (x < 0 || x >= WIDTH || y < 0 || y >= HEIGHT) return;
    *(volatile uint16_t*)(screen_picture + ((uint32_t)y << 10) + ((uint32_t)x << 1)) = colour;
}

static inline void screen_fill(int x, int y, int width, int height, uint16_t colour) {
    for (int row = y; row < y + height; ++row)
        for (int column = x; column < x + width; ++column) screen_plot(column, row, colour);
}

// The whole picture, two pixels with each write: half as many accesses, half the time.
static inline void screen_clear(uint16_t colour) {
    for (uint32_t y = 0; y < HEIGHT; ++y)
        for (uint32_t x = 0; x < WIDTH; x += 2)
            REGISTER(screen_picture + (y << 10) + (x << 1)) = (uint32_t)colour << 16 | colour;
}

// Shows what was drawn: waits for the end of the frame.  From then on the other picture is drawn.
static inline void screen_show(void) {
    PIXEL_BUFFER = 1;  // a write of any value asks for the change
    while (PIXEL_STATUS & 1) {
    }
    screen_picture = PIXEL_BACK_BUFFER;
}

// Characters lie over the picture, 80 in a line, 60 lines.  A space lets the picture through.
static inline void screen_text(int column, int line, const char* text) {
    volatile char* at = (volatile char*)(CHARACTERS + (line << 7) + column);
    while (*text) *at++ = *text++;
}

// Both pictures black, no text.
static inline void screen_begin(void) {
    PIXEL_BACK_BUFFER = PICTURE_2;
    screen_picture = PICTURE_2;
    for (int picture = 0; picture < 2; ++picture) {
        screen_clear(0);
        screen_show();
    }
    for (int line = 0; line < LINES; ++line)
        for (int column = 0; column < COLUMNS; ++column) screen_text(column, line, " ");
}
