// pong.c - the arrow keys hold a bat under a ball; a hit beeps and counts on HEX, a miss is the end.
//
// All of it is in the SDRAM, the pictures are a global array that is shown by turns.  The ball goes
// two pixels per picture to the side and three down; it is faster after each hit.
#include "processor.h"
#include "registers.h"

enum { WIDTH = 320, HEIGHT = 240, BALL = 8, BAT = 48, FLOOR = 228, STEP = 5 };
enum { EXTENDED = 0xE0, BREAK = 0xF0, LEFT = 0x6B, RIGHT = 0x74 };
enum { BEEP = 640, HALF_WAVE = 6 };  // samples of 8 kHz: 80 ms of 667 Hz

__attribute__((naked, section(".text._start"))) void _start(void) {
    __asm__("ldr sp, =0xC3FFFFF8 \n bl main \n b .");
}

static uint16_t pictures[2][HEIGHT][512] __attribute__((aligned(1024)));
static int left, right, beep;

// What the keyboard has sent: which of the two arrows are down.
static void look_at_keys(void) {
    static int extended, released;
    for (uint32_t data; (data = PS2_0_DATA) & 0x8000;) {
        const uint32_t byte = data & 0xFF;
        if (byte == EXTENDED) {
            extended = 1;
        } else if (byte == BREAK) {
            released = 1;
        } else {
            if (extended && byte == LEFT) left = !released;
            if (extended && byte == RIGHT) right = !released;
            extended = released = 0;
        }
    }
}

static void sound(void) {
    while (AUDIO_FIFOSPACE & 0x00FF0000) {
        const uint32_t sample = beep == 0                     ? 0
                                : beep-- / HALF_WAVE % 2 == 0 ? 0x20000000
                                                              : 0xE0000000;
        AUDIO_LEFTDATA = sample;
        AUDIO_RIGHTDATA = sample;
    }
}

static void box(uint16_t (*picture)[512], int x, int y, int width, int height, uint16_t colour) {
    for (int row = y; row < y + height; ++row)
        for (int column = x; column < x + width; ++column) picture[row][column] = colour;
}

static void draw(int ball_x, int ball_y, int bat) {
    uint16_t(*picture)[512] = pictures[PIXEL_BUFFER == (uint32_t)pictures[0]];
    box(picture, 0, 0, WIDTH, HEIGHT, 0x0008);
    for (int x = 0; x < WIDTH; x += 16) box(picture, x, FLOOR + 4, 8, 2, 0x7BEF);
    box(picture, bat, FLOOR, BAT, 4, 0xFFE0);
    box(picture, ball_x, ball_y, BALL, BALL, 0xF800);
    PIXEL_BACK_BUFFER = (uint32_t)picture;
    PIXEL_BUFFER = 1;
    while (PIXEL_STATUS & 1) {
        sound();
        look_at_keys();
    }
}

int main(void) {
    int x = 60, y = 12, across = 2, down = 3, bat = (WIDTH - BAT) / 2, hits = 0;
    HEX3_0_DATA = DIGITS[0];
    for (;;) {
        draw(x, y, bat);
        bat += STEP * (right - left);
        if (bat < 0) bat = 0;
        if (bat > WIDTH - BAT) bat = WIDTH - BAT;
        x += across, y += down;
        if (x < 0 || x > WIDTH - BALL) x -= 2 * across, across = -across;
        if (y < 0) y -= 2 * down, down = -down;
        if (y + BALL <= FLOOR) continue;
        if (x + BALL <= bat || x >= bat + BAT) break;
        down = -down - 1;
        y = FLOOR - BALL;
        beep = BEEP;
        HEX3_0_DATA = DIGITS[++hits];
    }
    const char* text = "MISSED";
    for (int i = 0; text[i]; ++i) *(volatile char*)(0xC9000000 + (30 << 7) + 37 + i) = text[i];
    LEDR_DATA = 0x3FF;
    for (;;) sound();
}
