// melody.c - plays a melody once, and again whenever KEY0 is pressed
//
// The audio core takes 8,000 samples per second and keeps 128 of them.  A program that waits for room
// before it writes a sample is never too fast, and it counts time in samples.
#include "processor.h"
#include "registers.h"

enum { RATE_HZ = 8000, LOUD = 0x30000000, BEAT = RATE_HZ / 5 };  // BEAT in samples: 200 ms

struct Note {
    unsigned hz, beats;
};

enum { C4 = 262, D4 = 294, E4 = 330, F4 = 349, G4 = 392 };

static const struct Note MELODY[] = {{E4, 1}, {E4, 1}, {F4, 1}, {G4, 1}, {G4, 1}, {F4, 1}, {E4, 1},
                                     {D4, 1}, {C4, 1}, {C4, 1}, {D4, 1}, {E4, 1}, {E4, 1}, {D4, 1},
                                     {D4, 2}};
enum { NOTES = sizeof MELODY / sizeof MELODY[0] };

static void play_sample(int32_t sample) {
    while ((AUDIO_FIFOSPACE & 0x00FF0000) == 0) {  // no room on the right side
    }
    AUDIO_LEFTDATA = (uint32_t)sample;
    AUDIO_RIGHTDATA = (uint32_t)sample;
}

// A triangle wave that fades.  `phase` counts 65,536 in a period, so 65536 * hz / RATE_HZ in a sample.
static void play(const struct Note* note) {
    const unsigned length = note->beats * BEAT;
    uint16_t phase = 0;
    for (unsigned n = 0; n < length; ++n) {
        phase = (uint16_t)(phase + 65536 * note->hz / RATE_HZ);
        const int32_t triangle = phase < 32768 ? phase - 16384 : 49152 - phase;  // +- 16,384
        const int32_t volume = LOUD / 16384 / (int32_t)length * (int32_t)(length - n);
        play_sample(triangle * volume);
    }
}

int main(void) {
    for (;;) {
        for (unsigned n = 0; n < NOTES; ++n) {
            HEX3_0_DATA = (uint32_t)DIGITS[(n + 1) / 10] << 8 | DIGITS[(n + 1) % 10];
            play(&MELODY[n]);
        }
        HEX3_0_DATA = 0;
        KEY_EDGE = 1;
        while ((KEY_EDGE & 1) == 0) {
        }
    }
}
