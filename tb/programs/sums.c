// sums.c - something to debug: a sum of squares goes to the LEDs; then waits for interrupts.
#include <stdint.h>

#define REGISTER(address) (*(volatile uint32_t*)(address))

volatile int total, rounds;
volatile double mean;

__attribute__((noinline)) int square(int x) {
    __asm volatile("");
    return x * x;
}

__attribute__((noinline)) void add_squares(int count) {
    for (int i = 1; i <= count; ++i) {
        const int one = square(i);
        total += one;
    }
}

int main(void) {
    add_squares(4);
    mean = total / 4.0;
    REGISTER(0xFF200000) = (uint32_t)total;
    for (;;) {
        ++rounds;
        __asm volatile("wfi");
    }
}
