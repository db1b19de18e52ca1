// first_system.c - the LEDs show the switches; while KEY1 is held, how often KEY0 was pressed
//
// KEY0 interrupts.  The counts are kept in the FPGA's on-chip memory.
#include <stdint.h>

#define REGISTER(address) (*(volatile uint32_t*)(address))
#define LEDS REGISTER(0xFF200000)
#define SWITCHES REGISTER(0xFF200010)
#define KEYS REGISTER(0xFF200020)
#define KEYS_MASK REGISTER(0xFF200028)
#define KEYS_EDGES REGISTER(0xFF20002C)
#define SYSTEM_ID REGISTER(0xFF201000)
#define COUNT (*(volatile uint64_t*)0xC0000100)

#define ICCICR REGISTER(0xFFFEC100)
#define ICCPMR REGISTER(0xFFFEC104)
#define ICCIAR REGISTER(0xFFFEC10C)
#define ICCEOIR REGISTER(0xFFFEC110)
#define ICDDCR REGISTER(0xFFFED000)
#define ICDISER(id) REGISTER(0xFFFED100 + (id) / 32 * 4)
#define ICDIPTR(id) (*(volatile uint8_t*)(0xFFFED800 + (id)))

enum { KEYS_INTERRUPT = 72, KEY0 = 1, KEY1 = 2 };

void __attribute__((interrupt("IRQ"))) on_irq(void) {
    const uint32_t id = ICCIAR & 0x3FF;
    if (id == KEYS_INTERRUPT) {
        KEYS_EDGES = KEY0;
        ++COUNT;
    }
    ICCEOIR = id;
}

int main(void) {
    if (SYSTEM_ID != 0xDEADBEEF) return 1;
    COUNT = 0;
    KEYS_EDGES = 0xF;
    KEYS_MASK = KEY0;
    ICDIPTR(KEYS_INTERRUPT) = 1;
    ICDISER(KEYS_INTERRUPT) = 1u << KEYS_INTERRUPT % 32;
    ICCPMR = 0xFF;
    ICCICR = 1;
    ICDDCR = 1;
    __asm__ volatile("cpsie i");
    for (;;) LEDS = KEYS & KEY1 ? SWITCHES : (uint32_t)COUNT;
}
