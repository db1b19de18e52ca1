// snapshot.c - a camera: what comes in by video-in is on the screen; KEY0 takes a picture, which stays,
// KEY1 goes on, KEY2 shows the edges instead or no longer.
//
// HEX0 is the number of pictures taken, LEDR0 is lit while the picture stays.
#include "processor.h"
#include "registers.h"

enum { ENABLE = 4 };

static uint32_t pressed(void) {
    const uint32_t keys = KEY_EDGE;
    KEY_EDGE = keys;
    return keys;
}

int main(void) {
    unsigned taken = 0;
    VIDEO_IN_STATUS = ENABLE;
    HEX3_0_DATA = DIGITS[0];
    for (;;) {
        const uint32_t keys = pressed();
        if (keys & 1) {
            VIDEO_IN_STATUS = 0;
            HEX3_0_DATA = DIGITS[++taken % 10];
            LEDR_DATA = 1;
        }
        if (keys & 2) {
            VIDEO_IN_STATUS = ENABLE;
            LEDR_DATA = 0;
        }
        if (keys & 4) EDGE_DETECTION_CONTROL ^= 1;
    }
}
