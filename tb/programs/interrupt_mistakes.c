// interrupt_mistakes.c - waits for two interrupts of KEY, or of the private timer, with one thing
// forgotten that the switches number.
#include "processor.h"
#include "registers.h"

enum { KEY_ID = 73, TIMER_ID = 29 };
enum {
    NOTHING,
    TARGET,
    PRIORITY_MASK,
    DEVICE_MASK,
    CPSR_I,
    ENABLE,
    DISTRIBUTOR,
    CPU_INTERFACE,
    END,          // the handler does not write ICCEOIR
    CAUSE,        // nor KEY_EDGE
    ACKNOWLEDGE,  // nor reads ICCIAR
    TIMER_INTERRUPT,
    NON_SECURE
};

static volatile uint32_t mistake, calls;

void __attribute__((interrupt("IRQ"))) on_irq(void) {
    ++calls;
    if (mistake == ACKNOWLEDGE) return;
    const uint32_t id = ICCIAR;
    if (mistake != CAUSE) KEY_EDGE = 0xF;
    if (mistake != END) ICCEOIR = id;
}

int main(void) {
    mistake = SW_DATA;
    const unsigned id = mistake == TIMER_INTERRUPT ? TIMER_ID : KEY_ID;
    if (mistake != TARGET) ICDIPTR(id) = 1;
    if (mistake != ENABLE) ICDISER(id) = 1u << id % 32;
    if (mistake != PRIORITY_MASK) ICCPMR = 0xF0;
    if (mistake != CPU_INTERFACE) ICCICR = 1;
    if (mistake != DISTRIBUTOR) ICDDCR = 1;
    if (mistake == NON_SECURE) REGISTER(0xFFFED080 + id / 32 * 4) = 1u << id % 32;
    if (mistake != DEVICE_MASK && mistake != TIMER_INTERRUPT) KEY_MASK = 0xF;
    A9_TIMER_LOAD = 1000;
    A9_TIMER_CONTROL = 1;
    if (mistake != CPSR_I) __asm volatile("cpsie i");
    while (calls < 2 || mistake == CAUSE || mistake == ACKNOWLEDGE) {
    }
    LEDR_DATA = 0x3FF;
    for (;;) {
    }
}
