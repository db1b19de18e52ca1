// counter.c - shows how often the FPGA's counter has interrupted: each 10 ms
#include <stdint.h>

#define REGISTER(address) (*(volatile uint32_t*)(address))
#define COUNT REGISTER(0xFF200000)
#define LIMIT REGISTER(0xFF200004)
#define CONTROL REGISTER(0xFF200008)
#define STATUS REGISTER(0xFF20000C)
#define DIGITS REGISTER(0xFF200010)

#define ICCICR REGISTER(0xFFFEC100)
#define ICCPMR REGISTER(0xFFFEC104)
#define ICCIAR REGISTER(0xFFFEC10C)
#define ICCEOIR REGISTER(0xFFFEC110)
#define ICDDCR REGISTER(0xFFFED000)
#define ICDISER(id) REGISTER(0xFFFED100 + (id) / 32 * 4)
#define ICDIPTR(id) (*(volatile uint8_t*)(0xFFFED800 + (id)))

enum { COUNTER_INTERRUPT = 72, COUNTS = 1, INTERRUPTS = 2 };

static uint32_t decimal(uint32_t number) {
    uint32_t digits = 0;
    for (int place = 0; place < 16; place += 4, number /= 10) digits |= number % 10 << place;
    return digits;
}

void __attribute__((interrupt("IRQ"))) on_irq(void) {
    static uint32_t interrupts;
    const uint32_t id = ICCIAR & 0x3FF;
    if (id == COUNTER_INTERRUPT) {
        STATUS = 1;
        DIGITS = decimal(++interrupts);
    }
    ICCEOIR = id;
}

int main(void) {
    ICDIPTR(COUNTER_INTERRUPT) = 1;
    ICDISER(COUNTER_INTERRUPT) = 1u << COUNTER_INTERRUPT % 32;
    ICCPMR = 0xFF;
    ICCICR = 1;
    ICDDCR = 1;
    __asm__ volatile("cpsie i");
    LIMIT = 500000 - 1;  // clocks of 50 MHz
    CONTROL = COUNTS | INTERRUPTS;
    for (;;) __asm__ volatile("wfi");
}
