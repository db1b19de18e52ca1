// dies.c - an undefined instruction, whose vector spins (start.S).
#include "registers.h"

int main(void) {
    for (const char* c = "ready\n"; *c; ++c) REGISTER(0xFFC02000) = (uint32_t)*c;
    __asm volatile("udf #0");
    LEDR_DATA = 0x3FF;
    return 0;
}
