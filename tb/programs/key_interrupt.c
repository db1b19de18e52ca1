// key_interrupt.c - KEY1 interrupts through the GIC (ID 73) and shows how often on HEX; sleeps in
// between.  In the manner of the DE1-SoC Computer's courses: edge capture, cleared by the handler.
#include <stdint.h>

#define REGISTER(address) (*(volatile uint32_t*)(address))
#define BYTE(address) (*(volatile uint8_t*)(address))
#define HEX3_0 REGISTER(0xFF200020)
#define KEY_MASK REGISTER(0xFF200058)
#define KEY_EDGE REGISTER(0xFF20005C)
#define ICCICR REGISTER(0xFFFEC100)
#define ICCPMR REGISTER(0xFFFEC104)
#define ICCIAR REGISTER(0xFFFEC10C)
#define ICCEOIR REGISTER(0xFFFEC110)
#define ICDDCR REGISTER(0xFFFED000)
#define ICDISER(id) REGISTER(0xFFFED100 + (id) / 32 * 4)
#define ICDIPTR(id) BYTE(0xFFFED800 + (id))

enum { KEY = 73 };

static const uint8_t digits[] = {0x3F, 0x06, 0x5B, 0x4F, 0x66, 0x6D, 0x7D, 0x07, 0x7F, 0x6F};
static volatile uint32_t presses;

void __attribute__((interrupt("IRQ"))) on_irq(void) {
    const uint32_t id = ICCIAR;
    if (id == KEY) {
        KEY_EDGE = KEY_EDGE;
        HEX3_0 = digits[++presses % 10];
    }
    ICCEOIR = id;
}

int main(void) {
    KEY_MASK = 2;
    ICDIPTR(KEY) = 1;
    ICDISER(KEY) = 1u << KEY % 32;
    ICCPMR = 0xFFFF;
    ICCICR = 1;
    ICDDCR = 1;
    HEX3_0 = digits[0];
    __asm volatile("cpsie i");
    for (;;) __asm volatile("wfi");
}
