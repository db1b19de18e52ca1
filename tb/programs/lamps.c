// lamps.c - outputs besides the monitor's picture: LEDR, HEX, the HPS's LED, JP1's pins,
// characters.
//
// HEX shows 6, 7 and 9 in the forms that programs use besides a font's, and two dark digits.  With
// KEY0 pressed it goes on: JP1 counts to 300 as fast as it can, LEDR is dimmed to an eighth, and HEX
// shows 1 in one digit after the other.
#include "registers.h"

#define HPS_GPIO1_DATA REGISTER(0xFF709000)
#define HPS_GPIO1_DIRECTION REGISTER(0xFF709004)
#define CHARACTERS ((volatile char*)0xC9000000)

static void print(unsigned x, unsigned y, const char* text) {
    for (volatile char* to = CHARACTERS + (y << 7) + x; *text; ++text, ++to) *to = *text;
}

int main(void) {
    LEDR_DATA = 0x201;
    LEDR_DATA = 0x2AA;
    HEX3_0_DATA = 0x7C276700;  // "679 " in HEX3 to HEX0
    HEX5_4_DATA = 0x0000;
    HPS_GPIO1_DIRECTION = 1u << 24;
    HPS_GPIO1_DATA = 1u << 24;
    JP1_DIR = 0x0000F000;
    JP1_DATA = 0x00005000;
    print(2, 1, "score 12");
    print(0, 59, "\"end\"");
    while (!(KEY_DATA & 1)) {
    }
    JP1_DIR = 0x000003FF;
    for (unsigned i = 1; i <= 300; ++i) JP1_DATA = i;
    for (unsigned i = 0;; i = (i + 1) % 8) {
        LEDR_DATA = i == 0 ? 0x3FF : 0;
        HEX3_0_DATA = i < 4 ? 0x06u << 8 * i : 0;
        HEX5_4_DATA = i == 4 || i == 5 ? 0x06u << 8 * (i - 4) : 0;
    }
}
