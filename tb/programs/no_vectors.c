// no_vectors.c - reads an address without a target, without a handler: entry at main, no start-up.
#include <stdint.h>

void main_without_vectors(void) {
    (void)*(volatile uint32_t*)0xFFC00000;
    for (;;) {
    }
}
