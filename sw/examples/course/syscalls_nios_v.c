// syscalls_nios_v.c - what picolibc, the C library for Nios V, needs of a program
//
// printf and scanf are at the JTAG UART's terminal, without a buffer; time begins at power-on.
#include <stdint.h>
#include <stdio.h>
#include <sys/time.h>

#define REGISTER(address) (*(volatile uint32_t*)(address))
#define JTAG_UART_DATA REGISTER(0xFF201000)
#define JTAG_UART_CONTROL REGISTER(0xFF201004)
#define MTIME_LOW REGISTER(0xFF202100)
#define MTIME_HIGH REGISTER(0xFF202104)

static int put(char c, FILE* file) {
    while (JTAG_UART_CONTROL >> 16 == 0) {  // WSPACE: no room
    }
    JTAG_UART_DATA = (uint8_t)c;
    return (uint8_t)c;
}

// Waits for one character.
static int get(FILE* file) {
    uint32_t data;
    do data = JTAG_UART_DATA;
    while ((data & 0x8000) == 0);  // RVALID
    return data & 0xFF;
}

static FILE terminal = FDEV_SETUP_STREAM(put, get, NULL, _FDEV_SETUP_RW);
FILE *const stdin = &terminal, *const stdout = &terminal, *const stderr = &terminal;

int gettimeofday(struct timeval* time, void* zone) {
    uint32_t high, low;
    do {
        high = MTIME_HIGH;
        low = MTIME_LOW;
    } while (high != MTIME_HIGH);
    const uint64_t microseconds = ((uint64_t)high << 32 | low) / 100;  // counts at 100 MHz
    time->tv_sec = microseconds / 1000000;
    time->tv_usec = microseconds % 1000000;
    return 0;
}

// The program has ended, as nios_v.S ends it.
void _exit(int code) {
    __asm volatile("csrci mstatus, 8");
    for (;;) {
    }
}
