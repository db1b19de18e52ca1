// hps_and_pins.c - HPS_KEY lights the HPS LED; JP2 D3-D0 drive out what JP1 D31-D28 have, the other
// way round; JP1 D28's falling edges are counted on LEDR.
#include "registers.h"

#define JP1_EDGE REGISTER(0xFF20006C)
#define JP2 REGISTER(0xFF200070)
#define JP2_DIRECTION REGISTER(0xFF200074)
#define GPIO1_DATA REGISTER(0xFF709000)
#define GPIO1_DIRECTION REGISTER(0xFF709004)
#define GPIO1_PINS REGISTER(0xFF709050)

enum { LED = 1 << 24, KEY_UP = 1 << 25 };

int main(void) {
    uint32_t edges = 0;
    GPIO1_DIRECTION = LED;
    JP1_DIR = 0;
    JP2_DIRECTION = 0xF;
    JP1_EDGE = 0xFFFFFFFF;
    for (;;) {
        GPIO1_DATA = GPIO1_PINS & KEY_UP ? 0 : LED;
        JP2 = ~JP1_DATA >> 28;
        if (JP1_EDGE & 1u << 28) {
            JP1_EDGE = 1u << 28;
            LEDR_DATA = ++edges;
        }
    }
}
