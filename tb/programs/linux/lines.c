// lines.c - each 10 ms eight numbered lines, 80 samples, a pixel and the lamps anew, without end
#include <fcntl.h>
#include <stdint.h>
#include <stdio.h>
#include <sys/mman.h>
#include <time.h>

int main(void) {
    const int fd = open("/dev/mem", O_RDWR | O_SYNC);
    volatile uint32_t* lw = mmap(0, 0x200000, PROT_READ | PROT_WRITE, MAP_SHARED, fd, 0xFF200000);
    volatile uint16_t* picture =
        mmap(0, 0x40000, PROT_READ | PROT_WRITE, MAP_SHARED, fd, 0xC8000000);
    if (lw == MAP_FAILED || picture == MAP_FAILED) return 1;
    volatile uint32_t* audio = lw + 0x3040 / 4;  // control, space, left, right
    const struct timespec rest = {0, 10000000};
    for (unsigned round = 0;; ++round) {
        for (unsigned line = 0; line < 8; ++line) printf("line %08u\n", 8 * round + line);
        fflush(stdout);
        for (unsigned n = 0; n < 80; ++n)
            audio[2] = audio[3] = n % 20 < 10 ? 0x10000000 : 0xF0000000;
        picture[round % 240 * 512 + round % 320] = (uint16_t)(round * 2654435761u >> 16);
        lw[0] = round;
        nanosleep(&rest, 0);
    }
}
