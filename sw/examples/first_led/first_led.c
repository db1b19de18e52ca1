// first_led.c - the red LEDs show the switches; while KEY0 is pressed, the opposite
#include "registers.h"

int main(void) {
    for (;;) {
        const uint32_t switches = SW_DATA;
        LEDR_DATA = KEY_DATA & 1 ? ~switches : switches;
    }
}
