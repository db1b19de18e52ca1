// stores.c - a loop of additions and stores, for the ARM, for Nios V, and with LINUX for QEMU: prints
// the sum of what it has stored, and ends
#include <stdint.h>

enum { WORDS = 1024 };

static uint32_t words[WORDS], halves[WORDS];

static void store(uint32_t rounds) {
    uint32_t value = 1;
    for (uint32_t round = 0; round < rounds; ++round)
        for (uint32_t i = 0; i < WORDS; ++i) {
            value += i ^ round;
            words[i] = value;
            halves[i] += value >> 16;
        }
}

#ifdef LINUX  // of RISC-V

static void print(const char* text, uint32_t length) {
    register uint32_t file __asm("a0") = 1, number __asm("a7") = 64;
    register const char* begin __asm("a1") = text;
    register uint32_t size __asm("a2") = length;
    __asm volatile("ecall" : "+r"(file) : "r"(begin), "r"(size), "r"(number) : "memory");
}

int main(void);

void _start(void) {
    register int code __asm("a0") = main();
    register uint32_t number __asm("a7") = 93;
    __asm volatile("ecall" ::"r"(code), "r"(number));
    __builtin_unreachable();
}

#else

#include "registers.h"

static void print(const char* text, uint32_t length) {
    for (uint32_t i = 0; i < length; ++i) JTAG_UART0_DATA = (uint8_t)text[i];
}

#endif

int main(void) {
    store(ROUNDS);
    uint32_t sum = 0;
    for (uint32_t i = 0; i < WORDS; ++i) sum = sum * 31 + words[i] + halves[i];
    char text[9];
    for (int i = 0; i < 8; ++i) text[i] = "0123456789ABCDEF"[sum >> (28 - 4 * i) & 15];
    text[8] = '\n';
    print(text, sizeof text);
    return 0;
}
