// audio_echo.c - what comes in is played, and again 100 ms later at half the loudness, and so on.
// KEY1 puts in 40 ms of 1 kHz instead of the microphone's sound.
#include "registers.h"

enum { DELAY = 800, BURST = 320, HALF_PERIOD = 4, LOUD = 0x20000000 };

static int32_t past[DELAY];

int main(void) {
    uint32_t burst = 0;
    AUDIO_CONTROL = 4 | 8;  // both FIFOs empty
    AUDIO_CONTROL = 0;
    for (uint32_t n = 0;; n = (n + 1) % DELAY) {
        while ((AUDIO_FIFOSPACE & 0xFF) == 0) {
        }
        int32_t in = (int32_t)AUDIO_LEFTDATA / 2 + (int32_t)AUDIO_RIGHTDATA / 2;
        if (KEY_EDGE & 2) {
            KEY_EDGE = 2;
            burst = BURST;
        }
        if (burst) in += --burst / HALF_PERIOD % 2 ? LOUD : -LOUD;
        past[n] = in + past[n] / 2;
        while ((AUDIO_FIFOSPACE & 0x00FF0000) == 0) {
        }
        AUDIO_LEFTDATA = (uint32_t)past[n];
        AUDIO_RIGHTDATA = (uint32_t)past[n];
    }
}
