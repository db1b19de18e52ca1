// first_picture.c - a sunset: colours that change from row to row, a disc, and a line of text
#include "screen.h"

enum { HORIZON = 160, SUN_X = 160, SUN_Y = 120, SUN_RADIUS = 50 };

static int in_the_sun(int x, int y) {
    const int dx = x - SUN_X, dy = y - SUN_Y;
    return dx * dx + dy * dy < SUN_RADIUS * SUN_RADIUS;
}

static uint16_t colour_at(int x, int y) {
    if (y >= HORIZON) return rgb(0, 40, 80 + (y - HORIZON));
    if (in_the_sun(x, y)) return rgb(255, 220 - y, 0);
    return rgb(40 + y, 20 + y / 2, 120 - y / 2);
}

int main(void) {
    screen_begin();
    for (int y = 0; y < HEIGHT; ++y)
        for (int x = 0; x < WIDTH; ++x) screen_plot(x, y, colour_at(x, y));
    screen_text(34, 50, "Good evening");
    screen_show();
    return 0;
}
