// stands_still.c - draws a white line and ends: it branches to itself.
#include "registers.h"

int main(void) {
    for (unsigned x = 0; x < 320; ++x) *(volatile unsigned short*)(0xC8000000 + 2 * x) = 0xFFFF;
    for (;;) __asm volatile("");
}
