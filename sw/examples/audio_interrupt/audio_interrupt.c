// audio_interrupt.c - a tone of 400 Hz for 120 ms on each KEY0, written by the interrupt of the
// write FIFOs (ID 78), which asks for 96 samples or more at a time.  KEY0 by its own (ID 73).
#include "processor.h"
#include "registers.h"

enum { HALF_PERIOD = 10, LENGTH = 960, LOUD = 0x18000000 };

static volatile uint32_t left, fills;

static void fill(void) {
    while (AUDIO_FIFOSPACE & 0x00FF0000) {
        const int32_t wave = left / HALF_PERIOD % 2 ? LOUD : -LOUD;
        const uint32_t sample = left ? (uint32_t)wave : 0;
        if (left) --left;
        AUDIO_LEFTDATA = sample;
        AUDIO_RIGHTDATA = sample;
    }
    LEDR_DATA = ++fills;
}

INTERRUPT_HANDLER on_irq(void) {
    const uint32_t id = interrupt_begin();
    if (id == AUDIO_INTERRUPT) fill();
    if (id == KEY_INTERRUPT) {
        KEY_EDGE = 1;
        left = LENGTH;
    }
    interrupt_end(id);
}

int main(void) {
    interrupt_on(AUDIO_INTERRUPT);
    interrupt_on(KEY_INTERRUPT);
    KEY_MASK = 1;
    AUDIO_CONTROL = 2;  // WE
    interrupts_enable();
    for (;;) __asm volatile("wfi");
}
