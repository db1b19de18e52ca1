// line_in_echo.c - what comes in at LINE IN is played at once, and once more 250 ms later at half the
// loudness.  LEDR9-0 show how loud it is: 6 dB per LED.
#include "registers.h"

enum { DELAY = 2000, WINDOW = 160 };

static int32_t past_left[DELAY], past_right[DELAY];

static uint32_t bar(int32_t peak) {
    uint32_t lamps = 0;
    for (int32_t level = 0x40000000; level >= 0x00200000; level /= 2)
        lamps = lamps << 1 | (peak >= level);
    return lamps;
}

static int32_t magnitude(int32_t value) { return value < 0 ? ~value : value; }

int main(void) {
    int32_t peak = 0;
    AUDIO_CONTROL = 4 | 8;  // both FIFOs empty
    AUDIO_CONTROL = 0;
    for (uint32_t n = 0, count = 0;; n = (n + 1) % DELAY) {
        while ((AUDIO_FIFOSPACE & 0xFF) == 0) {
        }
        const int32_t left = (int32_t)AUDIO_LEFTDATA, right = (int32_t)AUDIO_RIGHTDATA;
        if (magnitude(left) > peak) peak = magnitude(left);
        if (++count == WINDOW) {
            LEDR_DATA = bar(peak);
            count = 0;
            peak = 0;
        }
        const int32_t echo_left = past_left[n] / 2, echo_right = past_right[n] / 2;
        past_left[n] = left;
        past_right[n] = right;
        while ((AUDIO_FIFOSPACE & 0x00FF0000) == 0) {
        }
        AUDIO_LEFTDATA = (uint32_t)(left / 2 + echo_left / 2);
        AUDIO_RIGHTDATA = (uint32_t)(right / 2 + echo_right / 2);
    }
}
