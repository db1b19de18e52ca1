// counts_edges.c - shows on LEDR how often KEY's edges were captured, in a loop that reads nothing
// else.
#include "registers.h"

#define KEY_EDGE REGISTER(0xFF20005C)

int main(void) {
    for (uint32_t count = 0;; LEDR_DATA = count) {
        uint32_t edges;
        while (!(edges = KEY_EDGE)) {
        }
        KEY_EDGE = edges;
        ++count;
    }
}
