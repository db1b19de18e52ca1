// oscilloscope.c - what comes in at LINE IN on the screen, from a rise through zero on; its frequency
// as text and on HEX.  KEY0 holds the picture.
//
// A pixel is a sample at 8 kHz, 40 per division; a vertical division is a quarter of full scale.
#include "memory.h"
#include "processor.h"
#include "registers.h"

enum { WIDTH = 320, HEIGHT = 240, MIDDLE = 120, DIVISION = 40, RATE = 8000, NOISE = 0x00800000 };

static int32_t samples[2 * WIDTH];

static uint16_t* pixel(uint32_t picture, int x, int y) {
    return (uint16_t*)(picture + ((uint32_t)y << 10) + ((uint32_t)x << 1));
}

static void record(void) {
    AUDIO_CONTROL = 4;  // drops the samples of the time in which the picture was drawn
    AUDIO_CONTROL = 0;
    for (int i = 0; i < 2 * WIDTH; ++i) {
        while ((AUDIO_FIFOSPACE & 0xFF) == 0) {
        }
        samples[i] = (int32_t)AUDIO_LEFTDATA;
        (void)AUDIO_RIGHTDATA;
    }
}

// The next place after `from` where it rises through zero, 0 if there is none before `end`.
static int rise(int from, int end) {
    int low = 0;
    for (int i = from; i < end; ++i) {
        low |= samples[i] < -NOISE;
        if (low && samples[i] >= 0) return i;
    }
    return 0;
}

static uint32_t frequency(int first) {
    int count = 0, last = first;
    for (int at; (at = rise(last + 1, 2 * WIDTH)) != 0; last = at) ++count;
    return count ? (uint32_t)((RATE * count + (last - first) / 2) / (last - first)) : 0;
}

static void write_number(uint32_t number) {
    static char line[] = "     Hz";
    uint32_t segments = 0;
    for (int i = 0; i < 4; ++i, number /= 10) {
        const int blank = i > 0 && number == 0;
        line[3 - i] = blank ? ' ' : (char)('0' + number % 10);
        if (!blank) segments |= (uint32_t)DIGITS[number % 10] << 8 * i;
    }
    HEX3_0_DATA = segments;
    for (int i = 0; line[i]; ++i) *(volatile char*)(CHARACTERS + (1 << 7) + 72 + i) = line[i];
}

static int height(int32_t sample) { return MIDDLE - (int)((int64_t)sample * DIVISION * 4 >> 31); }

static void draw(uint32_t picture, int first) {
    for (int y = 0; y < HEIGHT; ++y)
        for (int x = 0; x < WIDTH; ++x)
            *pixel(picture, x, y) = x % DIVISION == 0 || y % DIVISION == 0 ? 0x0320 : 0;
    for (int x = 1; x < WIDTH; ++x) {
        const int from = height(samples[first + x - 1]), to = height(samples[first + x]);
        const int top = from < to ? from : to, bottom = from < to ? to : from;
        for (int y = top < 0 ? 0 : top; y <= bottom && y < HEIGHT; ++y)
            *pixel(picture, x, y) = 0x07E0;
    }
}

int main(void) {
    uint32_t picture = PICTURES;
    for (;;) {
        while (KEY_DATA & 1) {
        }
        record();
        const int first = rise(0, WIDTH);
        draw(picture, first);
        PIXEL_BACK_BUFFER = picture;
        PIXEL_BUFFER = 1;
        while (PIXEL_STATUS & 1) {
        }
        write_number(frequency(first));
        picture = PIXEL_BACK_BUFFER;
    }
}
