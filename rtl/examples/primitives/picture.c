// picture.c - draws into the DDR3 what the FPGA shows: a sky, a meadow, and a ball that moves
//
// Two pictures: the one that is not shown is drawn.  The caches are off, so that the FPGA, which
// reads the memory itself, sees what was written.
#include <stdint.h>

#define REGISTER(address) (*(volatile uint32_t*)(address))
#define BASE REGISTER(0xFF200000)
#define FRAMES REGISTER(0xFF200004)

enum { WIDTH = 640, HEIGHT = 480, RADIUS = 40 };

typedef uint16_t Picture[HEIGHT][WIDTH];
static Picture* const pictures[2] = {(Picture*)0x20000000, (Picture*)0x20100000};

static uint16_t colour(unsigned red, unsigned green, unsigned blue) {
    return (uint16_t)(red >> 3 << 11 | green >> 2 << 5 | blue >> 3);
}

static uint16_t behind(int y) {
    return y < 320 ? colour(60 + (unsigned)y / 4, 120 + (unsigned)y / 4, 255) : colour(40, 150, 40);
}

static void draw_ball(Picture* picture, int x, int y, int is_shown) {
    for (int dy = -RADIUS; dy <= RADIUS; ++dy)
        for (int dx = -RADIUS; dx <= RADIUS; ++dx)
            if (dx * dx + dy * dy <= RADIUS * RADIUS)
                (*picture)[y + dy][x + dx] = is_shown ? colour(255, 90, 0) : behind(y + dy);
}

int main(void) {
    for (int n = 0; n < 2; ++n)
        for (int y = 0; y < HEIGHT; ++y)
            for (int x = 0; x < WIDTH; ++x) (*pictures[n])[y][x] = behind(y);
    int was[2] = {100, 100};
    for (int x = 100, n = 0;; n = !n) {
        draw_ball(pictures[n], was[n], 240, 0);
        draw_ball(pictures[n], x, 240, 1);
        was[n] = x;
        const uint32_t frame = FRAMES;
        BASE = (uint32_t)pictures[n];
        while (FRAMES == frame) {
        }
        x = x < WIDTH - 100 ? x + 4 : 100;
    }
}
