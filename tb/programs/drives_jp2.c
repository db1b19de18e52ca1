// drives_jp2.c - shows on the LEDs what JP2's data register reads after 0xA was written to it.
#include "registers.h"

int main(void) {
    JP2_DIR = 0xF;
    JP2_DATA = 0xA;
    LEDR_DATA = JP2_DATA & 0xF;
    for (;;) {
    }
}
