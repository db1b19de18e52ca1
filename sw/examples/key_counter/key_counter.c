// key_counter.c - KEY0 counts up and KEY1 down, by interrupts; the processor sleeps in between
//
// A key that is pressed interrupts the processor: it leaves the loop in main(), runs on_irq() and goes
// back.  So no press is missed, however long the loop takes, and a loop with nothing to do may sleep.
#include "processor.h"
#include "registers.h"

static volatile unsigned count;  // volatile: changed by on_irq(), read by main()

INTERRUPT_HANDLER on_irq(void) {
    const uint32_t id = interrupt_begin();  // which interrupt it is
    if (id == KEY_INTERRUPT) {
        const uint32_t pressed = KEY_EDGE;
        KEY_EDGE = pressed;  // a 1 clears its bit; otherwise the interrupt would come again at once
        if (pressed & 1) ++count;
        if (pressed & 2) --count;
    }
    interrupt_end(id);
}

int main(void) {
    KEY_MASK = 3;  // KEY0 and KEY1 may interrupt
    interrupt_on(KEY_INTERRUPT);
    interrupts_enable();  // interrupts are enabled in the processor
    for (;;) {
        const unsigned now = count;
        HEX3_0_DATA = (uint32_t)DIGITS[now / 10 % 10] << 8 | DIGITS[now % 10];
        __asm volatile("wfi");  // sleeps until the next interrupt
    }
}
