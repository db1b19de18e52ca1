// crash_report.c - fills both JTAG UARTs' FIFOs and the serial line, then jumps into empty memory.
#include "registers.h"

#define UART_THR REGISTER(0xFFC02000)
#define JTAG_UART1_DATA REGISTER(0xFF201008)
#define FIFO 64

int main(void) {
    for (unsigned n = 0; n < FIFO; ++n) JTAG_UART0_DATA = 'a';
    for (unsigned n = 0; n < FIFO; ++n) JTAG_UART1_DATA = 'b';
    for (unsigned n = 0; n < FIFO; ++n) UART_THR = 'c';
    ((void (*)(void))0x20000000)();
    return 0;
}
