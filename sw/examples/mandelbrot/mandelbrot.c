// mandelbrot.c - the Mandelbrot set; KEY0 zooms in, and a bar shows how far the picture is
//
// HEX0 counts the pictures that are ready.
//
// A point c of the plane belongs to the set if z = z * z + c, begun at 0, stays near 0 for ever.  A
// point that leaves gets a colour by the number of steps that it takes.
#include "processor.h"
#include "screen.h"

enum { STEPS = 500, BAR_COLUMN = 14, BAR_LINE = 57, BAR_LENGTH = 50, ZOOM_KEY = 1 };

static const double CENTRE_X = -0.743644, CENTRE_Y = 0.131826;  // full of spirals, at every scale

static int steps_until_it_leaves(double cx, double cy) {
    double x = 0, y = 0;
    for (int step = 0; step < STEPS; ++step) {
        const double xx = x * x, yy = y * y;
        if (xx + yy > 4) return step;
        y = 2 * x * y + cy;
        x = xx - yy + cx;
    }
    return STEPS;
}

// Dark blue, light blue, white, orange, and dark blue again.
static uint16_t colour_of(int steps) {
    static const uint8_t CORNERS[5][3] = {
        {0, 7, 100}, {32, 107, 203}, {237, 255, 255}, {255, 170, 0}, {0, 7, 100}};
    enum { BETWEEN = 16 };
    if (steps == STEPS) return 0;
    const uint8_t* from = CORNERS[steps / BETWEEN % 4];
    const uint8_t* to = CORNERS[steps / BETWEEN % 4 + 1];
    unsigned mixed[3];
    for (int i = 0; i < 3; ++i)
        mixed[i] = (unsigned)(from[i] + (to[i] - from[i]) * (steps % BETWEEN) / BETWEEN);
    return rgb(mixed[0], mixed[1], mixed[2]);
}

// On the monitor a bar of characters, and the ten LEDs from the left.
static void show_progress(int done, int all) {
    LEDR_DATA = 0x3FF & ~(0x3FFu >> done * 10 / all);
    screen_text(BAR_COLUMN, BAR_LINE, "[");
    for (int i = 0; i < BAR_LENGTH; ++i)
        screen_text(BAR_COLUMN + 1 + i, BAR_LINE, i < done * BAR_LENGTH / all ? "#" : ".");
    screen_text(BAR_COLUMN + 1 + BAR_LENGTH, BAR_LINE, "]");
}

static void hide_progress(void) {
    for (int column = 0; column < COLUMNS; ++column) screen_text(column, BAR_LINE, " ");
}

static void draw(double x, double y, double size_of_a_pixel) {
    for (int row = 0; row < HEIGHT; ++row) {
        for (int column = 0; column < WIDTH; ++column) {
            const double cx = x + (column - WIDTH / 2) * size_of_a_pixel;
            const double cy = y - (row - HEIGHT / 2) * size_of_a_pixel;
            screen_plot(column, row, colour_of(steps_until_it_leaves(cx, cy)));
        }
        if (row % 8 == 7) show_progress(row + 1, HEIGHT);
    }
    hide_progress();
    screen_show();
}

int main(void) {
    screen_begin();
    draw(-0.6, 0, 3.0 / WIDTH);  // the whole
    unsigned ready = 1;
    for (double size = 1.0 / WIDTH;; size /= 8) {
        HEX3_0_DATA = DIGITS[ready++ % 10];
        KEY_EDGE = ZOOM_KEY;
        while ((KEY_EDGE & ZOOM_KEY) == 0) {
        }
        draw(CENTRE_X, CENTRE_Y, size);
    }
}
