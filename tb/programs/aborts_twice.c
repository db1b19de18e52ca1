// aborts_twice.c - reads an address without a target, and a register whose bridge is in reset; then
// loops for ever.
#include "registers.h"

// Skips the access.
void __attribute__((naked)) on_data_abort(void) { __asm("subs pc, lr, #4"); }

int main(void) {
    (void)REGISTER(0xFFC00000);
    REGISTER(0xFFD0501C) = 2;  // lightweight bridge into reset
    (void)SW_DATA;
    REGISTER(0xFFD0501C) = 0;
    while (!(KEY_DATA & 1)) {
    }  // KEY0
    LEDR_DATA = 1;
    return 0;
}
