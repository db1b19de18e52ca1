// prints_much.c - 1.1 MiB on the serial line, in 1.9 s, then its checks, so that its first output
// has been dropped.  It counts while most of a line is sent, since a line asks for its state 1,000
// times, which is slow to simulate.
#include "registers.h"

#define UART_DLL REGISTER(0xFFC02000)
#define UART_THR REGISTER(0xFFC02000)
#define UART_LCR REGISTER(0xFFC0200C)
#define UART_LSR REGISTER(0xFFC02014)
#define DLAB 0x80
#define THR_EMPTY 0x20

enum { MOST_OF_A_LINE = 14000 };

static void print(const char* text) {
    while (!(UART_LSR & THR_EMPTY)) {
    }
    while (*text) UART_THR = (uint32_t)*text++;
    for (volatile int i = 0; i < MOST_OF_A_LINE; ++i) {
    }
}

int main(void) {
    UART_LCR = DLAB | 3;
    UART_DLL = 1;  // 6.25 Mbaud
    UART_LCR = 3;
    print("first\n");
    for (int line = 0; line < 17 * 1024; ++line)
        print("a line of 64 characters, as a program prints them by thousands.\n");
    print("TAP version 13\n1..2\nok 1 - counts\nnot ok 2 - adds: 3, expected 4\n");
    print("last\n");
    return 0;
}
