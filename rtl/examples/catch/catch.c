// catch.c - a game: the arrow keys move a basket under the ball that falls
//
// A ball that is caught counts on HEX0, and a tone sounds; one that is not costs an LED.  The picture
// has two buffers in the FPGA's SDRAM: what is drawn is shown from the next frame on.
#include <stdint.h>

#define REGISTER(address) (*(volatile uint32_t*)(address))
#define SCORE REGISTER(0xFF200000)  // segments of the digit
#define LIVES REGISTER(0xFF200010)
#define PS2 REGISTER(0xFF200100)
#define BUFFER REGISTER(0xFF200200)
#define BACK_BUFFER REGISTER(0xFF200204)
#define STATUS REGISTER(0xFF20020C)
#define AUDIO_SPACE REGISTER(0xFF200404)
#define AUDIO_LEFT REGISTER(0xFF200408)
#define AUDIO_RIGHT REGISTER(0xFF20040C)
#define SDRAM 0xC0000000

enum { WIDTH = 320, HEIGHT = 240, BASKET = 48, BALL = 8, GROUND = 224, STEP = 10, FALL = 12 };
enum { BLACK = 0, WHITE = 0xFFFF, ORANGE = 0xFD20 };
enum { LEFT = 0x6B, RIGHT = 0x74, RELEASED = 0xF0, EXTENDED = 0xE0 };

static void box(int x, int y, int width, int height, uint32_t color) {
    const uint32_t buffer = SDRAM + BACK_BUFFER;
    for (int row = y; row < y + height; ++row)  // two pixels at a time: x and width are even
        for (int column = x; column < x + width; column += 2)
            *(volatile uint32_t*)(buffer + (row << 10) + (column << 1)) = color << 16 | color;
}

static void show(void) {
    BUFFER = 1;
    while (STATUS & 1) {
    }
}

// -1, 0, 1: the arrow key that is held.
static int held(void) {
    static int released, direction;
    for (uint32_t data; (data = PS2) & 0x8000;) {
        const int code = data & 0xFF;
        if (code == LEFT || code == RIGHT) direction = released ? 0 : code == LEFT ? -1 : 1;
        if (code != EXTENDED) released = code == RELEASED;
    }
    return direction;
}

// Keeps the loudspeaker busy: 1,000 Hz at 8,000 samples per second, or silence.
static void sound(int on) {
    static int phase;
    while (AUDIO_SPACE >> 24) {
        const int16_t sample = !on ? 0 : phase & 4 ? 6000 : -6000;
        ++phase;
        AUDIO_LEFT = (uint16_t)sample;
        AUDIO_RIGHT = (uint16_t)sample;
    }
}

int main(void) {
    static const uint8_t digits[] = {0x3F, 0x06, 0x5B, 0x4F, 0x66, 0x6D, 0x7D, 0x07, 0x7F, 0x6F};
    int basket = (WIDTH - BASKET) / 2, ball = WIDTH / 2, y = 0, score = 0, tone = 0;
    struct {
        int basket, ball, y;
    } drawn[2] = {{0, 0, 0}, {0, 0, 0}};
    for (int buffer = 0; buffer < 2; ++buffer) {
        box(0, 0, WIDTH, HEIGHT, BLACK);
        show();
    }
    LIVES = 0x3FF;
    for (int buffer = 0;; buffer = !buffer) {
        SCORE = digits[score % 10];
        basket += held() * STEP;
        if (basket < 0) basket = 0;
        if (basket > WIDTH - BASKET) basket = WIDTH - BASKET;
        y += FALL;
        if (y >= GROUND - BALL) {
            if (ball + BALL > basket && ball < basket + BASKET) {
                ++score;
                tone = 6;
            } else {
                LIVES >>= 1;
            }
            ball = (ball + 44) % (WIDTH - BALL);
            y = 0;
        }
        box(drawn[buffer].ball, drawn[buffer].y, BALL, BALL, BLACK);
        box(drawn[buffer].basket, GROUND, BASKET, 6, BLACK);
        box(ball, y, BALL, BALL, WHITE);
        box(basket, GROUND, BASKET, 6, ORANGE);
        drawn[buffer].basket = basket;
        drawn[buffer].ball = ball;
        drawn[buffer].y = y;
        if (tone) --tone;
        sound(tone != 0);
        show();
    }
}
