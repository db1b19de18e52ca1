// terminals.c - prints what is typed at each of three terminals at the same one, with + before it.
#include "registers.h"

#define UART_DATA REGISTER(0xFFC02000)
#define UART_FCR REGISTER(0xFFC02008)
#define UART_LSR REGISTER(0xFFC02014)
#define JTAG_UART1_DATA REGISTER(0xFF201008)

int main(void) {
    UART_FCR = 1;
    for (const char* text = "\xC3\xA4 ready\n"; *text; ++text) UART_DATA = (uint8_t)*text;
    for (;;) {
        for (int n = 0; n < 50; ++n) __asm("wfe");  // 1 us each
        if (UART_LSR & 1) {
            const uint32_t character = UART_DATA;
            UART_DATA = '+';
            UART_DATA = character;
        }
        const uint32_t first = JTAG_UART0_DATA, second = JTAG_UART1_DATA;
        if (first & 0x8000) {
            JTAG_UART0_DATA = '+';
            JTAG_UART0_DATA = first & 0xFF;
        }
        if (second & 0x8000) {
            JTAG_UART1_DATA = '+';
            JTAG_UART1_DATA = second & 0xFF;
        }
    }
}
