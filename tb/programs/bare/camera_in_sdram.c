// camera_in_sdram.c - the camera's picture goes to the SDRAM and is shown from there, while the program
// writes to the SDRAM and reads it back all the time; KEY0 keeps the picture.
//
// HEX0 is 1 once the picture stays, the LEDs are the number of words that were not as written.
#include "processor.h"
#include "registers.h"

enum { PICTURE = 0xC0000000, WORDS = 256 };

int main(void) {
    volatile uint32_t* const words = (volatile uint32_t*)0xC0100000;
    uint32_t errors = 0;
    VIDEO_IN_BACK_BUFFER = PIXEL_BACK_BUFFER = PICTURE;
    VIDEO_IN_BUFFER = PIXEL_BUFFER = 1;
    VIDEO_IN_STATUS = 4;
    while ((VIDEO_IN_STATUS | PIXEL_STATUS) & 1) {
    }
    HEX3_0_DATA = DIGITS[0];
    for (uint32_t round = 1;; ++round) {
        for (uint32_t i = 0; i < WORDS; ++i) words[i] = round * i;
        for (uint32_t i = 0; i < WORDS; ++i) errors += words[i] != round * i;
        LEDR_DATA = errors;
        if (KEY_EDGE & 1) {
            VIDEO_IN_STATUS = 0;
            HEX3_0_DATA = DIGITS[1];
        }
    }
}
