// prompts.c - prints a line, the beginning of another and a byte that is no text; then it waits.
#include "registers.h"

int main(void) {
    for (const char* c = "first line\n\x1B[2J\xFFname: "; *c; ++c)
        REGISTER(0xFFC02000) = (uint8_t)*c;
    for (;;) __asm("wfi");
}
