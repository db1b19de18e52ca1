// everything.c - each input of the board, every 4 ms: one that has moved draws a line and sounds
//
// A line's colour and place and the sound depend on all inputs so far and on when they came, so a
// run with one input more, or 4 ms later, has another picture and other sound.
#include <fcntl.h>
#include <stdint.h>
#include <stdio.h>
#include <sys/mman.h>
#include <termios.h>
#include <time.h>
#include <unistd.h>

static volatile uint32_t* lw;
static volatile uint16_t* picture;
static uint32_t state = 1;

static void mix(uint32_t value) { state = (state ^ value) * 16777619u + (state >> 15); }

static uint32_t take(unsigned offset, uint32_t valid) {  // a FIFO's next word
    const uint32_t word = lw[offset / 4];
    return word & valid ? word : 0;
}

int main(void) {
    const int fd = open("/dev/mem", O_RDWR | O_SYNC);
    lw = mmap(0, 0x200000, PROT_READ | PROT_WRITE, MAP_SHARED, fd, 0xFF200000);
    picture = mmap(0, 0x40000, PROT_READ | PROT_WRITE, MAP_SHARED, fd, 0xC8000000);
    if (lw == MAP_FAILED || picture == MAP_FAILED) return 1;
    struct termios terminal;
    tcgetattr(0, &terminal);
    terminal.c_lflag &= ~(tcflag_t)(ICANON | ECHO);
    terminal.c_cc[VMIN] = terminal.c_cc[VTIME] = 0;
    tcsetattr(0, TCSANOW, &terminal);
    lw[0x5000 / 4] = 1;    // the keypad
    lw[0x108 / 4] = 0xF4;  // the mouse reports
    puts("ready");
    fflush(stdout);
    const struct timespec rest = {0, 4000000};
    uint32_t key = 0, sw = 0, keypad = 0, volts[8] = {0};
    for (uint32_t round = 0;; ++round) {
        const uint32_t before = state;
        if (round % 16 == 0) lw[0x4000 / 4] = 1;  // the AD converter, once
        uint32_t word;
        if ((word = lw[0x50 / 4]) != key) mix(1000 + (key = word));
        if ((word = lw[0x40 / 4]) != sw) mix(2000 + (sw = word));
        if ((word = lw[0x5008 / 4]) != keypad) mix(3000 + (keypad = word));
        for (int n = 0; n < 8; ++n)
            if ((word = lw[0x4000 / 4 + n] & 0xFFF) != volts[n]) mix(4000 + (volts[n] = word));
        for (unsigned port = 0x100; port <= 0x108; port += 8)
            while ((word = take(port, 0x8000))) mix(port << 8 | (word & 0xFF));
        for (unsigned line = 0x1000; line <= 0x1008; line += 8)
            while ((word = take(line, 0x8000))) mix(line << 8 | (word & 0xFF));
        char typed;
        while (read(0, &typed, 1) == 1) mix(0x500000u + (uint8_t)typed);
        if (state != before) {
            mix(round);
            const uint32_t y = state % 240;
            for (uint32_t x = 0; x < 320; ++x) picture[y * 512 + x] = (uint16_t)(state >> 8);
            for (uint32_t n = 0; n < 60; ++n)
                lw[0x3048 / 4] = lw[0x304C / 4] = n % 8 < 4 ? state >> 2 : -(state >> 2);
            lw[0] = state;
            printf("%08x\n", state);
            fflush(stdout);
        }
        nanosleep(&rest, 0);
    }
}
