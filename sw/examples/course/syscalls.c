// syscalls.c - the system calls of newlib, the C library
//
// printf and scanf are at the JTAG UART's terminal; malloc has what lies between the program and
// the stack; time begins with the first question for it.
#include <errno.h>
#include <stddef.h>
#include <stdint.h>
#include <sys/stat.h>
#include <sys/time.h>
#include <sys/times.h>
#include <time.h>

#define REGISTER(address) (*(volatile uint32_t*)(address))
#define JTAG_UART_DATA REGISTER(0xFF201000)
#define JTAG_UART_CONTROL REGISTER(0xFF201004)
#define GLOBAL_TIMER_LOW REGISTER(0xFFFEC200)
#define GLOBAL_TIMER_HIGH REGISTER(0xFFFEC204)
#define GLOBAL_TIMER_CONTROL REGISTER(0xFFFEC208)

void* _sbrk(ptrdiff_t bytes) {
    extern char heap_begin[];
    static char* heap_end = heap_begin;
    char* const stack = __builtin_frame_address(0);
    if (bytes > stack - heap_end) {
        errno = ENOMEM;
        return (void*)-1;
    }
    char* const before = heap_end;
    heap_end += bytes;
    return before;
}

int _write(int file, const char* text, int count) {
    for (int i = 0; i < count; ++i) {
        while (JTAG_UART_CONTROL >> 16 == 0) {  // WSPACE: no room
        }
        JTAG_UART_DATA = text[i];
    }
    return count;
}

// Waits for one character.
int _read(int file, char* text, int count) {
    uint32_t data;
    do data = JTAG_UART_DATA;
    while ((data & 0x8000) == 0);  // RVALID
    *text = data;
    return 1;
}

static uint64_t microseconds(void) {
    GLOBAL_TIMER_CONTROL |= 1;
    uint32_t high, low;
    do {
        high = GLOBAL_TIMER_HIGH;
        low = GLOBAL_TIMER_LOW;
    } while (high != GLOBAL_TIMER_HIGH);
    return ((uint64_t)high << 32 | low) / 200;  // counts at 200 MHz
}

int _gettimeofday(struct timeval* time, void* zone) {
    const uint64_t now = microseconds();
    time->tv_sec = now / 1000000;
    time->tv_usec = now % 1000000;
    return 0;
}

clock_t _times(struct tms* times) {
    const clock_t now = microseconds() * CLOCKS_PER_SEC / 1000000;
    *times = (struct tms){.tms_utime = now};
    return now;
}

// The program has ended, as start.S ends it.
void _exit(int code) {
    __asm volatile("cpsid if");
    for (;;) {
    }
}

void _init(void) {}
void _fini(void) {}
int _kill(int process, int signal) { _exit(1); }
int _getpid(void) { return 1; }
int _open(const char* name, int flags, int mode) { return -1; }  // there are no files
int _close(int file) { return -1; }
int _lseek(int file, int offset, int from) { return 0; }
int getentropy(void* to, size_t bytes) { return -1; }  // nor is there chance
int _isatty(int file) { return 1; }
int _fstat(int file, struct stat* status) {
    status->st_mode = S_IFCHR;
    return 0;
}
