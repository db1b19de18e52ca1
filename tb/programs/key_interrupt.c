// key_interrupt.c - KEY1 interrupts through the GIC (ID 73) and shows how often on HEX; sleeps in
// between.  In the manner of the DE1-SoC Computer's courses: edge capture, cleared by the handler.
#include "processor.h"
#include "registers.h"

enum { KEY_ID = 73 };

static volatile uint32_t presses;

void __attribute__((interrupt("IRQ"))) on_irq(void) {
    const uint32_t id = ICCIAR;
    if (id == KEY_ID) {
        KEY_EDGE = KEY_EDGE;
        HEX3_0_DATA = DIGITS[++presses % 10];
    }
    ICCEOIR = id;
}

int main(void) {
    KEY_MASK = 2;
    interrupt_on(KEY_ID);
    HEX3_0_DATA = DIGITS[0];
    __asm volatile("cpsie i");
    for (;;) __asm volatile("wfi");
}
