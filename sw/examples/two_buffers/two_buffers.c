// two_buffers.c - two pictures in the SDRAM, one after the other, by turns; a ball on a chessboard
//
// A picture is 240 rows of 1,024 bytes, so the second one begins 0x3C000 after the first.
#include "memory.h"
#include "processor.h"
#include "registers.h"

enum { WIDTH = 320, HEIGHT = 240 };
enum { FIRST = PICTURES, SECOND = PICTURES + 0x3C000 };

static void draw(uint32_t picture, int ball) {
    for (int y = 0; y < HEIGHT; ++y)
        for (int x = 0; x < WIDTH; ++x) {
            const int dx = x - ball, dy = y - 120;
            const uint16_t board = (x / 40 + y / 40) % 2 ? 0x39E7 : 0x0000;
            *(volatile uint16_t*)(picture + ((uint32_t)y << 10) + ((uint32_t)x << 1)) =
                dx * dx + dy * dy < 900 ? 0xF800 : board;
        }
}

int main(void) {
    draw(FIRST, 40);
    draw(SECOND, 40);
    PIXEL_BACK_BUFFER = FIRST;
    PIXEL_BUFFER = 1;
    for (int ball = 40;; ball = ball < 280 ? ball + 40 : 280) {
        while (PIXEL_STATUS & 1) {
        }
        HEX3_0_DATA = DIGITS[ball / 40];
        const uint32_t picture = PIXEL_BUFFER == FIRST ? SECOND : FIRST;
        PIXEL_BACK_BUFFER = picture;
        draw(picture, ball < 280 ? ball + 40 : 280);
        PIXEL_BUFFER = 1;
    }
}
