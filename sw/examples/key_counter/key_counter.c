// key_counter.c - KEY0 counts up and KEY1 down, by interrupts; the processor sleeps in between
//
// A key that is pressed interrupts the processor: it leaves the loop in main(), runs on_irq() and goes
// back.  So no press is missed, however long the loop takes, and a loop with nothing to do may sleep.
#include "processor.h"
#include "registers.h"

enum { KEYS = 73 };  // the number of the keys' interrupt

static volatile unsigned count;  // volatile: changed by on_irq(), read by main()

void __attribute__((interrupt("IRQ"))) on_irq(void) {
    const uint32_t id = ICCIAR;  // which interrupt; the interrupt controller now waits for ICCEOIR
    if (id == KEYS) {
        const uint32_t pressed = KEY_EDGE;
        KEY_EDGE = pressed;  // a 1 clears its bit; otherwise the interrupt would come again at once
        if (pressed & 1) ++count;
        if (pressed & 2) --count;
    }
    ICCEOIR = id;
}

int main(void) {
    KEY_MASK = 3;  // KEY0 and KEY1 may interrupt
    interrupt_on(KEYS);
    __asm volatile("cpsie i");  // interrupts are enabled in the processor
    for (;;) {
        const unsigned now = count;
        HEX3_0_DATA = (uint32_t)DIGITS[now / 10 % 10] << 8 | DIGITS[now % 10];
        __asm volatile("wfi");  // sleeps until the next interrupt
    }
}
