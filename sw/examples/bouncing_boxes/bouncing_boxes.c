// bouncing_boxes.c - eight boxes on a line that closes on itself, in two pictures by turns.
//
// One picture is in the on-chip SRAM, the other in the SDRAM.  Positions are floats: the VFP has to
// be on.  It clears 260 rows of 512 pixels, so it also writes beyond the on-chip SRAM.
#include "memory.h"
#include "registers.h"

enum { WIDTH = 320, HEIGHT = 240, ROWS = 260, BOXES = 8, SIZE = 8 };

static uint32_t picture;

struct Box {
    float x, y, dx, dy;
};

static void plot(int x, int y, uint16_t colour) {
    *(volatile uint16_t*)(picture + ((uint32_t)y << 10) + ((uint32_t)x << 1)) = colour;
}

static int magnitude(int value) { return value < 0 ? -value : value; }

// Bresenham's, from one end to the other.
static void line(int x0, int y0, int x1, int y1, uint16_t colour) {
    const int dx = magnitude(x1 - x0), dy = -magnitude(y1 - y0);
    const int sx = x0 < x1 ? 1 : -1, sy = y0 < y1 ? 1 : -1;
    for (int error = dx + dy;;) {
        plot(x0, y0, colour);
        if (x0 == x1 && y0 == y1) return;
        const int twice = 2 * error;
        if (twice >= dy) error += dy, x0 += sx;
        if (twice <= dx) error += dx, y0 += sy;
    }
}

static void clear(void) {
    for (uint32_t offset = 0; offset < ROWS << 10; offset += 4) REGISTER(picture + offset) = 0;
}

static void swap(void) {
    PIXEL_BUFFER = 1;
    while (PIXEL_STATUS & 1) {
    }
    picture = PIXEL_BACK_BUFFER;
}

static void draw(const struct Box* boxes) {
    for (int i = 0; i < BOXES; ++i) {
        const struct Box *here = &boxes[i], *next = &boxes[(i + 1) % BOXES];
        line((int)here->x, (int)here->y, (int)next->x, (int)next->y, 0x07FF);
        for (int y = -SIZE / 2; y < SIZE / 2; ++y)
            for (int x = -SIZE / 2; x < SIZE / 2; ++x)
                plot((int)here->x + x, (int)here->y + y, (uint16_t)(0xF800 >> i));
    }
}

static void move(struct Box* box) {
    box->x += box->dx;
    box->y += box->dy;
    if (box->x < SIZE || box->x > WIDTH - SIZE) box->dx = -box->dx;
    if (box->y < SIZE || box->y > HEIGHT - SIZE) box->dy = -box->dy;
}

int main(void) {
    struct Box boxes[BOXES];
    for (int i = 0; i < BOXES; ++i) {
        const struct Box box = {20.0f + 39.0f * (float)i, 30.0f + 25.0f * (float)(i * 3 % 8),
                                i % 2 ? 1.5f : -1.5f, i % 3 ? 1.25f : -2.0f};
        boxes[i] = box;
    }
    PIXEL_BACK_BUFFER = ONCHIP;
    swap();
    clear();
    PIXEL_BACK_BUFFER = PICTURES;
    picture = PIXEL_BACK_BUFFER;
    for (;;) {
        clear();
        draw(boxes);
        for (int i = 0; i < BOXES; ++i) move(&boxes[i]);
        swap();
    }
}
