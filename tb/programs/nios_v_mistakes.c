// nios_v_mistakes.c - KEY0 lights the LEDs by its interrupt, unless the switches say which mistake to
// make; with 4 on them main() returns
#include "processor.h"
#include "registers.h"

enum { NOTHING, MSTATUS, MIE, DEVICE_MASK, RETURN };

INTERRUPT_HANDLER on_irq(void) {
    LEDR_DATA = 0x3FF;
    KEY_EDGE = 1;
}

int main(void) {
    for (volatile int wait = 0; wait < 3000; ++wait) {  // for the switches
    }
    const uint32_t mistake = SW_DATA & 7;
    if (mistake == RETURN) return 0;
    if (mistake != DEVICE_MASK) KEY_MASK = 1;
    interrupt_on(mistake == MIE ? AUDIO_INTERRUPT : KEY_INTERRUPT);
    if (mistake != MSTATUS) interrupts_enable();
    for (;;) __asm volatile("nop");
}
