// microphone_level.c - how loud it is on LEDR9-0, 6 dB per LED: at LINE IN, or at the microphone
// while SW0 is up.
#include "registers.h"

enum { ANALOGUE_PATH = 4, POWER_DOWN = 6, LINE = 0x12, MICROPHONE = 0x14, WINDOW = 160 };
enum { AUTO_INIT_OK = 0x100, READY = 2 };

static void codec(uint32_t number, uint32_t value) {
    while ((AV_CONFIG_STATUS & READY) == 0) {
    }
    AV_CONFIG_ADDRESS = number;
    AV_CONFIG_DATA = value;
}

static uint32_t bar(int32_t peak) {
    uint32_t lamps = 0;
    for (int32_t level = 0x40000000; level >= 0x00200000; level /= 2)
        lamps = lamps << 1 | (peak >= level);
    return lamps;
}

int main(void) {
    while ((AV_CONFIG_STATUS & AUTO_INIT_OK) == 0) {
    }
    codec(POWER_DOWN, 0);
    AUDIO_CONTROL = 4;  // read FIFOs empty
    AUDIO_CONTROL = 0;
    for (uint32_t up = 0;;) {
        int32_t peak = 0;
        for (int count = 0; count < WINDOW; ++count) {
            while ((AUDIO_FIFOSPACE & 0xFF) == 0) {
            }
            const int32_t left = (int32_t)AUDIO_LEFTDATA, right = (int32_t)AUDIO_RIGHTDATA;
            if (left > peak) peak = left;
            if (right > peak) peak = right;
        }
        LEDR_DATA = bar(peak);
        if ((SW_DATA & 1) != up) {
            up = SW_DATA & 1;
            codec(ANALOGUE_PATH, up ? MICROPHONE : LINE);
        }
    }
}
