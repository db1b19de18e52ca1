// av_config.c - waits for the codec to be set up, plays 500 Hz, and mutes it while KEY0 is held.
//
// The resampler must report that pixels have 16 bits (0x14 in bits 5:0); otherwise LEDR shows 1 and nothing plays.
#include "registers.h"

enum { DIGITAL_PATH = 5, MUTE = 8, AUTO_INIT_OK = 0x100, READY = 2, NOT_ACKNOWLEDGED = 1 };

static void codec(uint32_t number, uint32_t value) {
    while ((AV_CONFIG_STATUS & READY) == 0) {
    }
    AV_CONFIG_ADDRESS = number;
    AV_CONFIG_DATA = value;
    while ((AV_CONFIG_STATUS & READY) == 0) {
    }
    if (AV_CONFIG_STATUS & NOT_ACKNOWLEDGED) LEDR_DATA = 2;
}

int main(void) {
    if ((RESAMPLER_STATUS & 0x3F) != 0x14) {
        LEDR_DATA = 1;
        return 1;
    }
    while ((AV_CONFIG_STATUS & AUTO_INIT_OK) == 0) {
    }
    LEDR_DATA = 0x200;
    for (uint32_t n = 0, muted = 0;; ++n) {
        const uint32_t held = KEY_DATA & 1;
        if (held != muted) codec(DIGITAL_PATH, held ? MUTE : 0);
        muted = held;
        const uint32_t sample = n / 8 % 2 ? 0x10000000 : 0xF0000000;
        while ((AUDIO_FIFOSPACE & 0x00FF0000) == 0) {
        }
        AUDIO_LEFTDATA = sample;
        AUDIO_RIGHTDATA = sample;
    }
}
