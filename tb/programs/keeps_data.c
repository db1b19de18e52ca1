// keeps_data.c - uses the FPGA's SDRAM as memory, and asks for no picture.
#include "registers.h"

int main(void) {
    for (uint32_t n = 0; n < 1000; ++n) ((volatile uint32_t*)0xC0000000)[n] = n;
    LEDR_DATA = ((volatile uint32_t*)0xC0000000)[5];
    for (;;) {
    }
}
