// low_bits.c - how often the A9's private timer, read after KEY, ends in each of 16 ways.
//
// Then the same in the interrupt of an interval timer: both as programs take random numbers.
#include "registers.h"

#define PRIVATE_LOAD REGISTER(0xFFFEC600)
#define PRIVATE_COUNTER REGISTER(0xFFFEC604)
#define PRIVATE_CONTROL REGISTER(0xFFFEC608)
#define TIMER_STATUS REGISTER(0xFF202000)
#define TIMER_CONTROL REGISTER(0xFF202004)
#define TIMER_LOW REGISTER(0xFF202008)
#define TIMER_HIGH REGISTER(0xFF20200C)
#define GIC_CPU_CONTROL REGISTER(0xFFFEC100)
#define GIC_MASK REGISTER(0xFFFEC104)
#define GIC_ACKNOWLEDGE REGISTER(0xFFFEC10C)
#define GIC_END REGISTER(0xFFFEC110)
#define GIC_CONTROL REGISTER(0xFFFED000)
#define GIC_ENABLE_72 REGISTER(0xFFFED108)
#define GIC_TARGET_72 REGISTER(0xFFFED848)

enum { READS = 1600, INTERRUPTS = 1600, TIMER_ID = 72 };

static volatile unsigned counts[16], taken;

static void print(const char* text) {
    while (*text) REGISTER(0xFFC02000) = (uint32_t)*text++;
}

static void print_counts(const char* name) {
    print(name);
    for (unsigned i = 0; i < 16; ++i) {
        char digits[6] = " 0000";
        unsigned rest = counts[i];
        for (unsigned d = 4; d > 0; --d, rest /= 10) digits[d] = (char)('0' + rest % 10);
        print(digits);
        counts[i] = 0;
    }
    print("\n");
}

__attribute__((interrupt("IRQ"))) void on_irq(void) {
    ++counts[PRIVATE_COUNTER & 15];
    const uint32_t id = GIC_ACKNOWLEDGE;
    TIMER_STATUS = 0;
    ++taken;
    GIC_END = id;
}

int main(void) {
    PRIVATE_LOAD = 0xFFFFFFFF;
    PRIVATE_CONTROL = 3;
    for (unsigned i = 0; i < READS; ++i) {
        (void)KEY_DATA;
        ++counts[PRIVATE_COUNTER & 15];
    }
    print_counts("after KEY:");

    TIMER_LOW = 9999;  // 100 us
    TIMER_HIGH = 0;
    TIMER_CONTROL = 7;
    GIC_TARGET_72 = 1;
    GIC_ENABLE_72 = 1u << (TIMER_ID - 64);
    GIC_MASK = 0xFF;
    GIC_CPU_CONTROL = 1;
    GIC_CONTROL = 1;
    __asm volatile("cpsie i");
    while (taken < INTERRUPTS) __asm volatile("wfi");
    __asm volatile("cpsid i");
    TIMER_CONTROL = 8;  // stop, or its interrupt wakes for ever
    TIMER_STATUS = 0;
    print_counts("in an interrupt:");
    for (;;) __asm volatile("");
}
