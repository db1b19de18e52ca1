// frames.c - computes for 0.84 ms, then sleeps for 0.84 ms, and so on: half of every frame
#include <time.h>

int main(void) {
    const struct timespec rest = {0, 840000};
    for (;;) {
        // Two instructions per iteration, 2.5 ns each with --cpi 2.
        for (int i = 0; i < 168000; ++i) __asm__ volatile("");
        nanosleep(&rest, 0);
    }
}
