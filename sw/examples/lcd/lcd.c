// lcd.c - a ball rolls over the LCD of a DE10-Standard; KEY0 inverts the picture while it is held
//
// The LCD (controller NT7534) is at the processor: SPI master 0 sends it bytes, GPIO41 says whether
// a byte is a command (0) or eight dots below each other.
#include "registers.h"

#define GPIO1_DATA REGISTER(0xFF709000)
#define GPIO1_DIRECTION REGISTER(0xFF709004)
#define SPI_CONTROL REGISTER(0xFFF00000)
#define SPI_ENABLE REGISTER(0xFFF00008)
#define SPI_SLAVES REGISTER(0xFFF00010)
#define SPI_DIVIDER REGISTER(0xFFF00014)
#define SPI_STATUS REGISTER(0xFFF00028)
#define SPI_DATA REGISTER(0xFFF00060)
#define RESETS REGISTER(0xFFD05014)

enum { BACKLIGHT = 1 << 8, IS_DATA = 1 << 12, RESET_N = 1 << 15 };             // of GPIO1
enum { BUSY = 1, ALL_SENT = 4, SEND_ALONE = 1 << 8, EIGHT_BITS = 7, SPI0_RESET = 1 << 18 };
enum { WIDTH = 128, PAGES = 8, RADIUS = 9, MIDDLE = 40, FLOOR = 50 };

static void send(uint32_t byte, int is_data) {
    while ((SPI_STATUS & (BUSY | ALL_SENT)) != ALL_SENT) {
    }
    GPIO1_DATA = BACKLIGHT | RESET_N | (is_data ? IS_DATA : 0);
    SPI_DATA = byte;
}

static void begin(void) {
    GPIO1_DIRECTION |= BACKLIGHT | IS_DATA | RESET_N;
    GPIO1_DATA = 0;
    RESETS &= ~SPI0_RESET;
    SPI_ENABLE = 0;
    SPI_CONTROL = SEND_ALONE | EIGHT_BITS;
    SPI_DIVIDER = 64;  // of 200 MHz
    SPI_SLAVES = 1;
    SPI_ENABLE = 1;
    send(0xC8, 0);  // line 0 is at the top
    send(0x2F, 0);  // power
    send(0x40, 0);  // line 0 is the first
    send(0xAF, 0);  // on
}

static int is_black(int x, int y, int ball) {
    const int right = x - ball, down = y - MIDDLE;
    return y >= FLOOR || right * right + down * down <= RADIUS * RADIUS;
}

static void draw(int ball) {
    for (int page = 0; page < PAGES; ++page) {
        send(0xB0 | (uint32_t)page, 0);
        send(0x10, 0);  // column 0
        send(0x00, 0);
        for (int x = 0; x < WIDTH; ++x) {
            uint32_t dots = 0;
            for (int y = 0; y < 8; ++y) dots |= (uint32_t)is_black(x, 8 * page + y, ball) << y;
            send(dots, 1);
        }
    }
}

int main(void) {
    begin();
    for (int ball = RADIUS;; ball = ball < WIDTH - RADIUS ? ball + 2 : RADIUS) {
        send(KEY_DATA & 1 ? 0xA7 : 0xA6, 0);
        draw(ball);
    }
}
