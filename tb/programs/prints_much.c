// prints_much.c - 1.25 MiB on the serial line, then its checks, so that its first output has been
// dropped.
#include "registers.h"

#define UART_THR REGISTER(0xFFC02000)

static void print(const char* text) {
    while (*text) UART_THR = (uint32_t)*text++;
}

int main(void) {
    print("first\n");
    for (int line = 0; line < 20 * 1024; ++line)
        print("a line of 64 characters, as a program prints them by thousands.\n");
    print("TAP version 13\n1..2\nok 1 - counts\nnot ok 2 - adds: 3, expected 4\n");
    print("last\n");
    return 0;
}
