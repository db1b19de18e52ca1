// aborts_twice.c - reads where nothing is, and a register whose bridge is in reset; then hangs.
#include <stdint.h>

#define REGISTER(address) (*(volatile uint32_t*)(address))

int main(void) {
    (void)REGISTER(0xFF2FF000);
    REGISTER(0xFFD0501C) = 2;  // lightweight bridge into reset
    (void)REGISTER(0xFF200040);
    REGISTER(0xFFD0501C) = 0;
    while (!(REGISTER(0xFF200050) & 1)) {}  // KEY0
    REGISTER(0xFF200000) = 1;
    return 0;
}
