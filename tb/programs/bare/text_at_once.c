// text_at_once.c - writes to the character buffer before anything else; LEDR0: it is still there.
#include "registers.h"

static volatile char* const TEXT = (volatile char*)0xC9000000;

int main(void) {
    int kept = 1;
    for (int y = 0; y < 60; y += 59)
        for (int x = 0; x < 80; ++x) TEXT[(y << 7) + x] = (char)('!' + x);
    for (volatile int i = 0; i < 100000; ++i) {
    }
    for (int y = 0; y < 60; ++y)
        for (int x = 0; x < 80; ++x)
            kept &= TEXT[(y << 7) + x] == (y == 0 || y == 59 ? (char)('!' + x) : 0);
    LEDR_DATA = kept ? 1 : 2;
    return 0;
}
