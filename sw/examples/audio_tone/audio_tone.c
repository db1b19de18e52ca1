// audio_tone.c - a square wave of 500 Hz while SW0 is on: waits for room, then writes both sides.
#include "registers.h"

enum { RATE_HZ = 8000, TONE_HZ = 500, LOUD = 0x20000000 };

int main(void) {
    for (uint32_t n = 0;; ++n) {
        while ((AUDIO_FIFOSPACE & 0x00FF0000) == 0) {
        }
        const int32_t high = n / (RATE_HZ / TONE_HZ / 2) % 2 ? LOUD : -LOUD;
        const uint32_t sample = SW_DATA & 1 ? (uint32_t)high : 0;
        AUDIO_LEFTDATA = sample;
        AUDIO_RIGHTDATA = sample;
    }
}
