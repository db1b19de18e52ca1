// all_pins.c - shows every bit of the parallel ports, the headers and the SDRAM's address, so that a
// wire that is broken, or is another one's, shows
//
// JP1 comes out at the digits and at JP2, the switches at LEDR, the keys at JTAG UART 0.
#include "registers.h"

#define SDRAM ((volatile uint32_t*)0xC0000000)

enum { WORDS_LOG2 = 24 };

static void put(char character) {
    while (JTAG_UART0_CONTROL >> 16 == 0) {}
    JTAG_UART0_DATA = (uint8_t)character;
}

static void print(const char* name, uint32_t value) {
    for (; *name; ++name) put(*name);
    for (int digit = 7; digit >= 0; --digit) put("0123456789ABCDEF"[value >> 4 * digit & 15]);
    put('\n');
}

// Words at each power of two, and a byte in each lane: how many are not what was written.
static uint32_t lost_in_sdram(void) {
    uint32_t lost = 0;
    for (unsigned bit = 0; bit < WORDS_LOG2; ++bit) SDRAM[1u << bit] = 0x9E3779B9u << bit | bit;
    for (unsigned lane = 0; lane < 4; ++lane) ((volatile uint8_t*)SDRAM)[lane] = 0xA0 | lane;
    for (unsigned bit = 0; bit < WORDS_LOG2; ++bit)
        lost += SDRAM[1u << bit] != (0x9E3779B9u << bit | bit);
    return lost + (SDRAM[0] != 0xA3A2A1A0);
}

// Each pin driven alone, as both headers read it back: how many are not what was written.
static uint32_t lost_on_headers(void) {
    uint32_t lost = 0;
    JP1_DIR = JP2_DIR = 0xFFFFFFFF;
    for (unsigned n = 0; n < 32; ++n) {
        JP1_DATA = JP2_DATA = 1u << n;
        lost += JP1_DATA != 1u << n || JP2_DATA != 1u << n;
    }
    JP1_DIR = 0;
    return lost;
}

int main(void) {
    static const uint8_t segments[16] = {0x3F, 0x06, 0x5B, 0x4F, 0x66, 0x6D, 0x7D, 0x07,
                                         0x7F, 0x6F, 0x77, 0x7C, 0x39, 0x5E, 0x79, 0x71};
    print("SDRAM ", lost_in_sdram());
    print("headers ", lost_on_headers());
    for (uint32_t keys = 0;;) {
        const uint32_t jp1 = JP1_DATA, shown = jp1 ^ 0x123456;
        LEDR_DATA = SW_DATA;
        JP2_DATA = jp1;
        uint32_t digits[2] = {0, 0};
        for (unsigned n = 0; n < 6; ++n)
            digits[n / 4] |= (uint32_t)segments[shown >> 4 * n & 15] << 8 * (n % 4);
        HEX3_0_DATA = digits[0];
        HEX5_4_DATA = digits[1];
        if (KEY_DATA != keys) print("keys ", keys = KEY_DATA);
    }
}
