// synthesizer.c - the 16 keys on JP1 play notes, several at a time; the monitor shows the wave
//
//     1 2 3 A      C4 D4 E4 F4      SW1-0 choose the sound: 0 triangle, 1 square, 2 saw-tooth, 3 organ.
//     4 5 6 B      G4 A4 B4 C5      LEDR shows how loud it is.
//     7 8 9 C      D5 E5 F5 G5
//     0 F E D      A5 B5 C6 D6
//
// Two activities run at different rates.  The audio core interrupts 83 times per second or more,
// when it has room for 96 samples: on_irq() computes them.  main() looks at the keys and draws, 60
// times per second.  They share a few variables, which are volatile.
#include "processor.h"
#include "screen.h"

enum { WRITE_INTERRUPT = 2 };
enum { RATE_HZ = 8000, NOTES = 16, LOUDEST = 1 << 12, WAVE = 512 };

static const uint16_t HZ[NOTES] = {262, 294, 330, 349, 392, 440, 494, 523,
                                   587, 659, 698, 784, 880, 988, 1047, 1175};

static volatile uint32_t keys_down;   // bit n: note n
static volatile int16_t wave[WAVE];   // the last samples, as a ring
static volatile unsigned wave_end;    // where the next one goes

// ---- Sound: by the interrupt ----

static int triangle(uint16_t phase) { return phase < 32768 ? phase - 16384 : 49152 - phase; }

// From -16,384 to 16,384; a period is 65,536.
static int sound_at(uint16_t phase, unsigned kind) {
    switch (kind) {
        case 0: return triangle(phase);
        case 1: return phase < 32768 ? 8192 : -8192;
        case 2: return (phase - 32768) / 2;
        default:  // with the octave and the twelfth above
            return triangle(phase) / 2 + triangle((uint16_t)(2 * phase)) / 4 +
                   triangle((uint16_t)(3 * phase)) / 4;
    }
}

// All notes together.  One that begins gets loud within 16 ms, one that was let go fades in 0.25 s, so
// that nothing clicks.
static int next_sample(unsigned kind) {
    static uint16_t phase[NOTES];
    static int loudness[NOTES];
    int sum = 0;
    for (int n = 0; n < NOTES; ++n) {
        if (keys_down >> n & 1)
            loudness[n] += loudness[n] < LOUDEST ? 32 : 0;
        else
            loudness[n] -= loudness[n] > 0 ? 2 : 0;
        if (loudness[n] == 0) continue;
        phase[n] = (uint16_t)(phase[n] + 65536u * HZ[n] / RATE_HZ);
        sum += sound_at(phase[n], kind) * loudness[n] / LOUDEST;
    }
    return sum / 8;
}

INTERRUPT_HANDLER on_irq(void) {
    const uint32_t id = interrupt_begin();
    const unsigned kind = SW_DATA & 3;
    while (id == AUDIO_INTERRUPT && AUDIO_FIFOSPACE & 0x00FF0000) {
        const int sample = next_sample(kind);
        wave[wave_end] = (int16_t)sample;
        wave_end = (wave_end + 1) % WAVE;
        AUDIO_LEFTDATA = (uint32_t)sample << 16;  // the core's samples have 32 bits
        AUDIO_RIGHTDATA = (uint32_t)sample << 16;
    }
    interrupt_end(id);
}

// ---- Keys: a column is pulled low, then a key that is down pulls its row low ----
//
// Three keys at the corners of a rectangle also connect the wires of the fourth, which then seems
// pressed: the keypad has no diodes.

static uint32_t read_keys(void) {
    uint32_t down = 0;
    JP1_DIR = 0xF0;  // D7-D4, the columns from the left, are outputs
    for (int column = 0; column < 4; ++column) {
        JP1_DATA = 0xF0 & ~(0x80u >> column);
        const uint32_t rows = ~JP1_DATA;  // D3-D0, from the top
        for (int row = 0; row < 4; ++row)
            if (rows >> (3 - row) & 1) down |= 1u << (4 * row + column);
    }
    return down;
}

// ---- Picture ----

enum { MIDDLE = 80, SCALE = 96, KEY_WIDTH = 20, KEY_TOP = 170, KEY_HEIGHT = 56 };

static int sample_at(unsigned place) { return wave[place % WAVE]; }

// As an oscilloscope does: begins where the wave crosses 0 upwards, so the curve stands still.
static void draw_wave(void) {
    unsigned begin = wave_end;
    for (int i = 0; i < WAVE - WIDTH - 1; ++i, ++begin)
        if (sample_at(begin) < 0 && sample_at(begin + 1) >= 0) break;
    int before = sample_at(begin) / SCALE;
    for (int x = 0; x < WIDTH; ++x) {
        const int here = sample_at(begin + (unsigned)x) / SCALE;
        const int low = here < before ? here : before, high = here < before ? before : here;
        screen_fill(x, MIDDLE - high, 1, high - low + 1, rgb(80, 255, 120));
        before = here;
    }
}

static void draw(uint32_t down) {
    screen_clear(rgb(8, 16, 24));
    for (int y = 0; y < KEY_TOP; y += 40) screen_fill(0, y, WIDTH, 1, rgb(24, 64, 64));
    for (int x = 0; x < WIDTH; x += 40) screen_fill(x, 0, 1, KEY_TOP, rgb(24, 64, 64));
    draw_wave();
    for (int n = 0; n < NOTES; ++n)
        screen_fill(KEY_WIDTH * n + 1, KEY_TOP, KEY_WIDTH - 2, KEY_HEIGHT,
                    down >> n & 1 ? rgb(255, 140, 0) : rgb(240, 240, 230));
}

static void write_names(void) {
    static const char* const NAMES[NOTES] = {"C4", "D4", "E4", "F4", "G4", "A4", "B4", "C5",
                                             "D5", "E5", "F5", "G5", "A5", "B5", "C6", "D6"};
    static const char* const KEYS[NOTES] = {"1", "2", "3", "A", "4", "5", "6", "B",
                                            "7", "8", "9", "C", "0", "F", "E", "D"};
    for (int n = 0; n < NOTES; ++n) {
        screen_text(5 * n + 2, 58, KEYS[n]);
        screen_text(5 * n + 2, 41, NAMES[n]);
    }
}

// The loudest of the last samples, in tenths of 8,192, as a number of LEDs.
static void show_loudness(void) {
    int peak = 0;
    for (unsigned i = 0; i < WAVE; ++i)
        if (sample_at(i) > peak) peak = sample_at(i);
    LEDR_DATA = (1u << peak * 10 / 8192) - 1;
}

int main(void) {
    screen_begin();
    write_names();
    interrupt_on(AUDIO_INTERRUPT);
    AUDIO_CONTROL = WRITE_INTERRUPT;
    interrupts_enable();
    for (;;) {
        keys_down = read_keys();
        draw(keys_down);
        show_loudness();
        screen_show();
    }
}
