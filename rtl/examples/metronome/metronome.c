// metronome.c - without an operating system: the metronome's interrupt turns its beat around after
// eight, from 20 ms to 40 ms and back
#include <stdint.h>

#define REGISTER(address) (*(volatile uint32_t*)(address))
#define PERIOD REGISTER(0xFF200100)
#define BEATS REGISTER(0xFF200104)
#define STATUS REGISTER(0xFF200108)

#define ICCICR REGISTER(0xFFFEC100)
#define ICCPMR REGISTER(0xFFFEC104)
#define ICCIAR REGISTER(0xFFFEC10C)
#define ICCEOIR REGISTER(0xFFFEC110)
#define ICDDCR REGISTER(0xFFFED000)
#define ICDISER(id) REGISTER(0xFFFED100 + (id) / 32 * 4)
#define ICDIPTR(id) (*(volatile uint8_t*)(0xFFFED800 + (id)))

enum { INTERRUPT = 72, SHORT = 1000000, LONG = 2 * SHORT };  // clocks of 50 MHz

void __attribute__((interrupt("IRQ"))) on_irq(void) {
    const uint32_t id = ICCIAR & 0x3FF;
    if (id == INTERRUPT) {
        STATUS = 1;
        if (BEATS % 8 == 0) PERIOD = PERIOD == SHORT ? LONG : SHORT;
    }
    ICCEOIR = id;
}

int main(void) {
    ICDIPTR(INTERRUPT) = 1;
    ICDISER(INTERRUPT) = 1u << INTERRUPT % 32;
    ICCPMR = 0xFF;
    ICCICR = 1;
    ICDDCR = 1;
    __asm__ volatile("cpsie i");
    PERIOD = SHORT;
    for (;;) __asm__ volatile("wfi");
}
