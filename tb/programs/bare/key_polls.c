// key_polls.c - how many presses a loop notices that reads KEY twice in a round
//
// It remembers KEY, waits until it is released, and acts on what it remembered.  A press that begins
// between its two reads is missed, which is about every second one, whatever the loop's phase.
// LEDR9: six presses were noticed; LEDR8: more than 18, of the 24 that the scenario makes.
#include "registers.h"

#define NOTICED 0x200
#define TOO_MANY 0x100

int main(void) {
    for (unsigned noticed = 0;;) {
        const unsigned key = KEY_DATA;
        while (KEY_DATA) continue;
        if (key == 1) {
            ++noticed;
            LEDR_DATA = (noticed >= 6 ? NOTICED : 0) | (noticed > 18 ? TOO_MANY : 0);
        }
    }
}
