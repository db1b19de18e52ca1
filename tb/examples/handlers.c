// handlers.c - start.S calls a program's handlers by the names of Intel's Monitor Program: each
// lights its LED and goes on after what it handles.
#include "processor.h"
#include "registers.h"

void __attribute__((interrupt("UNDEF"))) __cs3_isr_undef(void) { LEDR_DATA |= 1; }
void __attribute__((interrupt("SWI"))) __cs3_isr_swi(void) { LEDR_DATA |= 2; }
void __attribute__((interrupt("ABORT"))) __cs3_isr_dabort(void) { LEDR_DATA |= 4; }
void __attribute__((interrupt("IRQ"))) __cs3_isr_irq(void) {
    const uint32_t id = ICCIAR;
    A9_TIMER_STATUS = 1;
    LEDR_DATA |= 8;
    ICCEOIR = id;
}

int main(void) {
    LEDR_DATA = 0;
    __asm volatile("udf #0");
    __asm volatile("svc #0" ::: "lr");
    (void)*(volatile uint32_t*)0xFFC00000;  // no memory
    interrupt_on(29);                       // the private timer
    A9_TIMER_LOAD = 1000;
    A9_TIMER_CONTROL = 5;  // counts once, interrupts
    __asm volatile("cpsie i");
    while ((LEDR_DATA & 8) == 0) {
    }
    LEDR_DATA |= 0x200;
    for (;;) {
    }
}
