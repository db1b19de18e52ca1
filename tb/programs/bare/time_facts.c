// time_facts.c - facts about the timers and the sound's rate
#include "processor.h"
#include "facts.h"

#define TIMER(number, offset) REGISTER(0xFF202000 + 0x20 * (number) + (offset))
#define A9_TIMER_COUNTER REGISTER(0xFFFEC604)

enum { STATUS = 0x0, CONTROL = 0x4, LOW = 0x8, HIGH = 0xC, SNAP_LOW = 0x10, SNAP_HIGH = 0x14 };
enum { TO = 1, RUN = 2, CONT = 2, START = 4, STOP = 8 };
enum { READ_ENABLE = 1, WRITE_ENABLE = 2, CLEAR_READ = 4, CLEAR_WRITE = 8, RI = 0x100, WI = 0x200 };
enum { DEPTH = 128 };

static uint32_t snapshot(unsigned timer) {
    TIMER(timer, SNAP_LOW) = 0;
    return TIMER(timer, SNAP_HIGH) << 16 | TIMER(timer, SNAP_LOW);
}

static void set_period(unsigned timer, uint32_t ticks) {
    TIMER(timer, LOW) = (ticks - 1) & 0xFFFF;
    TIMER(timer, HIGH) = (ticks - 1) >> 16;
}

// From `first` on: those of one interval timer.
static void interval_timer(unsigned timer, uint32_t first) {
    fact(first, (TIMER(timer, HIGH) << 16 | TIMER(timer, LOW)) + 1 == 12500000);  // 125 ms
    TIMER(timer, CONTROL) = CONT | START;
    fact(first + 1, TIMER(timer, STATUS) == RUN && TIMER(timer, CONTROL) == (CONT | START));
    const uint32_t before = snapshot(timer);
    wait_us(1000);
    fact(first + 2, about(before - snapshot(timer), 100000, 600));  // 100 MHz; see wait_us()
    TIMER(timer, CONTROL) = STOP;
    fact(first + 3, TIMER(timer, STATUS) == 0 && snapshot(timer) == snapshot(timer));
    TIMER(timer, LOW) = 0x12345678;
    fact(first + 4, TIMER(timer, LOW) == 0x5678);  // 16 bits
    set_period(timer, 50000);
    TIMER(timer, CONTROL) = START;  // once
    wait_us(400);
    fact(first + 5, TIMER(timer, STATUS) == RUN);
    wait_us(200);
    fact(first + 6, TIMER(timer, STATUS) == TO);
    TIMER(timer, STATUS) = 0;
    fact(first + 7, TIMER(timer, STATUS) == 0);
    TIMER(timer, CONTROL) = START | CONT;
    for (int i = 0; i < 3; ++i) {
        wait_us(510);
        fact(first + 8, TIMER(timer, STATUS) == (TO | RUN));
        TIMER(timer, STATUS) = 0xFFFF;
    }
    TIMER(timer, CONTROL) = STOP;
}

static void a9_timer(void) {
    set_period(0, 0x80000000);
    TIMER(0, CONTROL) = START;
    for (uint32_t prescaler = 0; prescaler < 256; prescaler += 85) {
        A9_TIMER_CONTROL = 0;
        A9_TIMER_LOAD = 200000 / (prescaler + 1) - 1;
        A9_TIMER_STATUS = 1;
        const uint32_t before = snapshot(0);
        A9_TIMER_CONTROL = prescaler << 8 | 3;  // A and E: again and again
        for (int i = 0; i < 3; ++i) {
            while (A9_TIMER_STATUS == 0) {
            }
            A9_TIMER_STATUS = 1;
            fact(40, A9_TIMER_STATUS == 0);
        }
        fact(41, about(before - snapshot(0), 300000, 1800));  // 3 ms
    }
    A9_TIMER_CONTROL = 0;
    A9_TIMER_LOAD = 1234;
    fact(42, A9_TIMER_COUNTER == 1234);
}

static void hps_timers(void) {
    static const uint32_t base[] = {0xFFC08000, 0xFFC09000, 0xFFD00000, 0xFFD01000};
    static const uint32_t mhz[] = {100, 100, 25, 25};
    for (int i = 0; i < 4; ++i) {
        REGISTER(base[i]) = 1000000;
        REGISTER(base[i] + 8) = 7;  // goes on from the load value, no interrupt
        wait_us(50);
        const uint32_t before = REGISTER(base[i] + 4);
        wait_us(1000);
        fact(50 + (uint32_t)i, about(before - REGISTER(base[i] + 4), 1000 * mhz[i], 6 * mhz[i]));
        REGISTER(base[i] + 8) = 0;
    }
}

static void sound(void) {
    AUDIO_CONTROL = CLEAR_READ | CLEAR_WRITE;
    fact(60, AUDIO_FIFOSPACE == 0);  // no room
    for (int i = 0; i < 2 * DEPTH; ++i) AUDIO_LEFTDATA = 0, AUDIO_RIGHTDATA = 0;  // held empty
    fact(61, AUDIO_FIFOSPACE == 0);
    AUDIO_CONTROL = READ_ENABLE | WRITE_ENABLE;
    for (int i = 0; i < 2 * DEPTH; ++i) AUDIO_LEFTDATA = 0, AUDIO_RIGHTDATA = 0;
    fact(62, AUDIO_FIFOSPACE >> 16 == 0 && (AUDIO_CONTROL & WI) == 0);
    for (uint32_t ms = 5; ms <= 15; ms += 5) {
        wait_us(5000);
        fact(63, about(AUDIO_FIFOSPACE >> 24, 8 * ms, 1) && about(AUDIO_FIFOSPACE >> 16 & 0xFF, 8 * ms, 1));
        fact(64, about(AUDIO_FIFOSPACE & 0xFF, 8 * ms, 1) && about(AUDIO_FIFOSPACE >> 8 & 0xFF, 8 * ms, 1));
        fact(65, !(AUDIO_CONTROL & WI) == (ms < 12) && !(AUDIO_CONTROL & RI) == (ms < 12));
    }
    wait_us(5000);
    fact(66, (AUDIO_FIFOSPACE & 0xFFFF) == 0x8080);  // 128 deep
    (void)AUDIO_LEFTDATA;
    fact(67, (AUDIO_FIFOSPACE & 0xFFFF) == 0x7F80 || (AUDIO_FIFOSPACE & 0xFFFF) == 0x8080);
    AUDIO_CONTROL = CLEAR_READ;
    fact(68, (AUDIO_FIFOSPACE & 0xFFFF) == 0);
    AUDIO_CONTROL = 0;
}

int main(void) {
    interval_timer(0, 1);
    interval_timer(1, 11);
    a9_timer();
    hps_timers();
    sound();
    LEDR_DATA = ALL_LEDS;
    return 0;
}
