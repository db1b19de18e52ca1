// remote.c - shows the last button of the infrared remote control: its code on HEX1-0, their number
// on the LEDs.
//
// The IrDA port receives light as zero bytes, so the first byte after a pause marks the begin of a
// light.  From one begin to the next it is 1.1 ms for a 0, 2.3 ms for a 1, 13.5 ms for the lead.
#include "processor.h"
#include "registers.h"

#define GLOBAL_TIMER REGISTER(0xFFFEC200)
#define GLOBAL_TIMER_CONTROL REGISTER(0xFFFEC208)

enum { MS = 200000 };  // ticks of 200 MHz

int main(void) {
    uint32_t seen = 0, began = 0, word = 0, bits = 32, buttons = 0;
    GLOBAL_TIMER_CONTROL = 1;
    for (;;) {
        if ((IRDA_DATA & 0x8000) == 0) continue;
        const uint32_t now = GLOBAL_TIMER, pause = now - seen, since = now - began;
        seen = now;
        if (pause < MS * 3 / 10) continue;
        began = now;
        if (since > 10 * MS) {
            bits = 0;
        } else if (bits < 32) {
            word = word >> 1 | (since > MS * 17 / 10 ? 0x80000000 : 0);
            const int whole = ++bits == 32 && (word & 0xFFFF) == 0x6B86;
            if (whole && ((word >> 16 ^ word >> 24) & 0xFF) == 0xFF) {
                HEX3_0_DATA = (uint32_t)DIGITS[word >> 20 & 15] << 8 | DIGITS[word >> 16 & 15];
                LEDR_DATA = ++buttons;
            }
        }
    }
}
