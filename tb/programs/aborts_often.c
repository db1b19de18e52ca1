// aborts_often.c - one instruction reads 300 addresses without a target.
#include "registers.h"

// Skips the access.
void __attribute__((naked)) on_data_abort(void) { __asm("subs pc, lr, #4"); }

static uint32_t __attribute__((noinline)) look(uint32_t address) { return REGISTER(address); }

int main(void) {
    for (uint32_t n = 0; n < 300; ++n) look(0xFFC00000 + 4 * n);
    for (const char* c = "done\n"; *c; ++c) REGISTER(0xFFC02000) = (uint32_t)*c;
    return 0;
}
