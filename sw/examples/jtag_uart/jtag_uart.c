// jtag_uart.c - the terminal: a prompt longer than the FIFO, then an echo of what is typed.
//
// LEDR9 is lit once the host has been seen (AC); the other LEDs count the characters typed.
#include "registers.h"

static void put(char c) {
    while ((JTAG_UART0_CONTROL & 0xFFFF0000) == 0) {
    }
    JTAG_UART0_DATA = c;
}

static void print(const char* text) {
    while (*text) put(*text++);
}

int main(void) {
    print("A prompt that is longer than the 64 characters for which the JTAG UART has room.\n> ");
    while ((JTAG_UART0_CONTROL & 0x400) == 0) {
    }
    LEDR_DATA = 0x200;
    for (uint32_t count = 0;;) {
        const uint32_t data = JTAG_UART0_DATA;
        if ((data & 0x8000) == 0) continue;
        LEDR_DATA = 0x200 | ++count;
        put(data & 0xFF);
        if ((data & 0xFF) == '\n') print("> ");
    }
}
