// processor_timer.c - one LED walks, a step every 50 ms, by the interrupt of the processor's own timer:
// the private timer of the Cortex-A9, the machine timer of Nios V.  KEY0 turns it round.
#include "processor.h"
#include "registers.h"

enum { STEP = OWN_TIMER_HZ / 20, LEDS = 10 };

static volatile unsigned place;  // volatile: changed by on_irq(), read by main()
static int backwards;

INTERRUPT_HANDLER on_irq(void) {
    const uint32_t id = interrupt_begin();
    if (id == OWN_TIMER_INTERRUPT) {
        own_timer_served(STEP);
        place = (place + (backwards ? LEDS - 1 : 1)) % LEDS;
    }
    if (id == KEY_INTERRUPT) {
        KEY_EDGE = 1;
        backwards = !backwards;
    }
    interrupt_end(id);
}

int main(void) {
    LEDR_DATA = 1;
    KEY_MASK = 1;
    interrupt_on(KEY_INTERRUPT);
    interrupt_on(OWN_TIMER_INTERRUPT);
    own_timer_begin(STEP);
    interrupts_enable();
    for (;;) {
        __asm volatile("wfi");  // sleeps until the next interrupt
        LEDR_DATA = 1u << place;
    }
}
